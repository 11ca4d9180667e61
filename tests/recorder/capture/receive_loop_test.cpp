#include "recorder/capture/receive_loop.h"

#include <gtest/gtest.h>

#include "tests/core/net/fake_source.h"
#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FakeClocks;
using test::FakeSource;
using test::logTime;

struct Receiving {
  explicit Receiving(std::size_t max_blocks = 16) : queue(max_blocks) {}

  /// Everything handed over so far.
  TakenOver take() { return queue.take(0ns); }
  /// Advances the time and makes a pass.
  bool passAfter(Nanoseconds duration) {
    clocks.pass(duration);
    const Result<bool> busy = loop.pass();
    EXPECT_TRUE(busy.ok());
    return busy.ok() && *busy;
  }

  FakeClocks clocks;
  FakeSource first{"127.0.0.1:1"};
  FakeSource second{"127.0.0.1:2"};
  HandOver queue;
  ReceiveLoop loop{{&first, &second}, [this] { return clocks.look(); }, queue};
};

TEST(ReceiveLoop, HandsOverWhatArrivedAtTheKernelsTime) {
  Receiving setup;
  setup.first.arrive({{"one", setup.clocks.wall() + 1ms}, {"two", setup.clocks.wall() + 2ms}});
  setup.second.arrive({{"three", setup.clocks.wall() + 1500us}});
  EXPECT_TRUE(setup.passAfter(3ms));
  EXPECT_FALSE(setup.passAfter(6ms));
  const TakenOver taken = setup.take();
  ASSERT_EQ(taken.blocks.size(), 1U);
  const auto arrivals = taken.blocks[0]->arrivals();
  ASSERT_EQ(arrivals.size(), 3U);
  EXPECT_EQ(arrivals[0].time, logTime(1ms));
  EXPECT_EQ(arrivals[1].time, logTime(2ms));
  EXPECT_EQ(arrivals[2].time, logTime(1500us));
  EXPECT_EQ(arrivals[2].endpoint, 1U);
  EXPECT_EQ(textOf(taken.blocks[0]->payload(arrivals[1])), "two");
  EXPECT_GE(taken.drained_until, logTime(9ms));
}

TEST(ReceiveLoop, NeverSaysDrainedAheadOfABlockThatIsHeldBack) {
  Receiving setup;
  setup.passAfter(1ms);
  const LogTime before = setup.take().drained_until;
  setup.first.arrive({{"one", setup.clocks.wall() + 1ms}});
  setup.passAfter(2ms);
  EXPECT_EQ(setup.take().drained_until, before);
}

TEST(ReceiveLoop, KeepsTheOrderOfASocketWhenStampsGoBack) {
  Receiving setup;
  setup.first.arrive({{"a", setup.clocks.wall() + 2ms}, {"b", setup.clocks.wall() + 1ms}});
  setup.passAfter(3ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  const auto arrivals = taken.blocks.at(0)->arrivals();
  EXPECT_EQ(arrivals[0].time, logTime(2ms));
  EXPECT_EQ(arrivals[1].time, logTime(2ms));
}

TEST(ReceiveLoop, CountsKernelDropsWithASpan) {
  Receiving setup;
  setup.passAfter(1ms);
  setup.second.drop(7);
  setup.second.arrive({{"after the gap", setup.clocks.wall()}});
  setup.passAfter(1ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].endpoint, 1U);
  EXPECT_EQ(taken.losses[0].counts, (LossCounts{7, 0, 0, 0}));
  EXPECT_GE(taken.losses[0].from, logTime(1ms));
  EXPECT_LE(taken.losses[0].until, logTime(3ms));
}

TEST(ReceiveLoop, FindsDropsAfterTheLastDatagramWhenIdleAndAtTheEnd) {
  Receiving setup;
  setup.first.drop(3, /*only_when_asked=*/true);
  setup.passAfter(60ms);
  TakenOver taken = setup.take();
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].counts.kernel, 3U);
  setup.first.drop(4, /*only_when_asked=*/true);
  ASSERT_TRUE(setup.loop.finish().ok());
  taken = setup.take();
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].counts.kernel, 4U);
  EXPECT_TRUE(taken.finished);
}

TEST(ReceiveLoop, CountsExactlyWhatAFullQueueDrops) {
  Receiving setup(/*max_blocks=*/2);
  const std::string payload(60'000, 'x');
  constexpr std::uint64_t kSent = 100;
  for (std::uint64_t i = 0; i < kSent; ++i) {
    setup.first.arrive({{payload, setup.clocks.wall() + 1us * i}});
  }
  for (int pass = 0; pass < 5; ++pass) setup.passAfter(1ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  std::uint64_t kept = 0;
  for (const auto& block : taken.blocks) kept += block->arrivals().size();
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(kept + taken.losses[0].counts.queue, kSent);
  EXPECT_EQ(taken.blocks.size(), 2U);
  EXPECT_EQ(taken.losses[0].until, logTime(99us));
}

TEST(ReceiveLoop, GoesOnWhenTheQueueHasRoomAgain) {
  Receiving setup(/*max_blocks=*/1);
  setup.first.arrive({{std::string(60'000, 'x'), setup.clocks.wall()}});
  setup.passAfter(10ms);
  setup.passAfter(10ms);
  TakenOver taken = setup.take();
  ASSERT_EQ(taken.blocks.size(), 1U);
  setup.first.arrive({{"dropped", setup.clocks.wall()}});
  setup.passAfter(10ms);
  setup.queue.giveBack(std::move(taken.blocks[0]));
  setup.first.arrive({{"kept", setup.clocks.wall()}});
  setup.passAfter(10ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  taken = setup.take();
  ASSERT_EQ(taken.blocks.size(), 1U);
  EXPECT_EQ(textOf(taken.blocks[0]->payload(taken.blocks[0]->arrivals()[0])), "kept");
  EXPECT_EQ(taken.losses.at(0).counts.queue, 1U);
}

TEST(ReceiveLoop, KeepsACutDatagramAndCountsIt) {
  Receiving setup;
  setup.first.arrive({{"cut", setup.clocks.wall(), "10.0.0.1", 1, /*truncated=*/true}});
  setup.passAfter(1ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  EXPECT_EQ(taken.blocks.at(0)->arrivals().size(), 1U);
  EXPECT_EQ(taken.losses.at(0).counts, (LossCounts{0, 0, 0, 1}));
}

TEST(ReceiveLoop, AWallClockStepIsToldAndBendsNoTime) {
  Receiving setup;
  setup.passAfter(1ms);
  setup.clocks.setWall(1h);
  setup.first.arrive({{"x", setup.clocks.wall() + 500us}});
  setup.passAfter(1ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  ASSERT_EQ(taken.steps.size(), 1U);
  EXPECT_EQ(taken.steps[0].step, Nanoseconds(1h));
  EXPECT_EQ(taken.blocks.at(0)->arrivals()[0].time, logTime(1500us));
}

TEST(ReceiveLoop, KeepsWhatItHasWhenASocketFails) {
  Receiving setup;
  setup.first.arrive({{"kept", setup.clocks.wall()}});
  setup.passAfter(1ms);
  setup.second.fail();
  setup.clocks.pass(1ms);
  EXPECT_FALSE(setup.loop.pass().ok());
  EXPECT_FALSE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  EXPECT_EQ(taken.blocks.at(0)->arrivals().size(), 1U);
  EXPECT_TRUE(taken.finished);
}

TEST(ReceiveLoop, KeepsWhereWatchedTrafficWasSent) {
  Receiving setup;
  const SocketAddress group = SocketAddress::parse("239.1.2.3", 5).value();
  setup.first.arrive({{"own", setup.clocks.wall()}});
  setup.second.watch(group);
  setup.second.arrive({{"watched", setup.clocks.wall()}, {"", setup.clocks.wall()}});
  setup.passAfter(1ms);
  ASSERT_TRUE(setup.loop.finish().ok());
  const TakenOver taken = setup.take();
  const DatagramBlock& block = *taken.blocks.at(0);
  ASSERT_EQ(block.arrivals().size(), 3U);
  EXPECT_EQ(block.destination(block.arrivals()[0]), std::nullopt);
  EXPECT_EQ(block.destination(block.arrivals()[1]), group);
  EXPECT_EQ(block.destination(block.arrivals()[2]), group);
  EXPECT_EQ(textOf(block.payload(block.arrivals()[1])), "watched");
}

TEST(ReceiveLoop, WhatTheSystemHoldsBackIsNotDrained) {
  Receiving setup;
  setup.first.holdBack(15ms);
  setup.passAfter(100ms);
  EXPECT_EQ(setup.take().drained_until, setup.loop.clock().now() - 15ms);
  EXPECT_EQ(setup.loop.deliveryDelay(), Nanoseconds(15ms));
}

struct Told {
  std::vector<std::string> notes;
  std::string teed;
};

/// The same with callbacks that keep their arguments.
ReceiveLoop telling(Receiving& setup, Told& told) {
  return {{&setup.first, &setup.second},
          [&setup] { return setup.clocks.look(); },
          setup.queue,
          {[&told](std::span<const ReceivedDatagram> batch) {
             for (const ReceivedDatagram& each : batch) told.teed += textOf(each.payload);
           },
           [&told](const std::string& note) { told.notes.push_back(note); }}};
}

TEST(ReceiveLoop, GivesTheTeeEverythingEvenWhatTheQueueDrops) {
  Receiving setup(/*max_blocks=*/0);
  Told told;
  ReceiveLoop loop = telling(setup, told);
  setup.first.arrive({{"a", setup.clocks.wall()}, {"b", setup.clocks.wall()}});
  setup.second.arrive({{"c", setup.clocks.wall()}});
  ASSERT_TRUE(loop.pass().ok());
  EXPECT_EQ(told.teed, "abc");
}

TEST(ReceiveLoop, SaysWhatASourceMended) {
  Receiving setup;
  Told told;
  ReceiveLoop loop = telling(setup, told);
  setup.first.mend("joined again");
  for (int i = 0; i < 10; ++i) {
    setup.clocks.pass(60ms);
    ASSERT_TRUE(loop.pass().ok());
  }
  EXPECT_EQ(told.notes, std::vector<std::string>{"joined again"});
}

TEST(ReceiveLoop, SaysOnceThatTheBufferIsSmallForTheRate) {
  Receiving setup;
  Told told;
  ReceiveLoop loop = telling(setup, told);
  // Both hold 100 datagrams; 10 ms of the one's rate.
  setup.first.grantBuffer(83'200);
  setup.second.grantBuffer(83'200);
  for (int i = 0; i < 3'000; ++i) {
    std::vector<FakeSource::Datagram> batch(10, {std::string(100, 'x'), setup.clocks.wall()});
    setup.first.arrive(std::move(batch));
    if (i % 10 == 0) setup.second.arrive({{"slow", setup.clocks.wall()}});
    setup.clocks.pass(1ms);
    ASSERT_TRUE(loop.pass().ok());
    for (auto& block : setup.take().blocks) setup.queue.giveBack(std::move(block));
  }
  ASSERT_EQ(told.notes.size(), 1U);
  EXPECT_NE(told.notes[0].find("the receive buffer of udp://127.0.0.1:1 holds 10 ms of 10"),
            std::string::npos)
      << told.notes[0];
  EXPECT_NEAR(loop.busiest(0).datagrams_a_second, 10'000, 100);
  EXPECT_EQ(loop.busiest(0).bytes_a_datagram, 100);
}

TEST(ReceiveLoop, EndsUnderAFloodThatGoesOn) {
  Receiving setup;
  for (int i = 0; i < 100'000; ++i) setup.first.arrive({{"x", setup.clocks.wall()}});
  FakeClocks& clocks = setup.clocks;
  ReceiveLoop loop(
      {&setup.first}, [&clocks] { return clocks.pass(1ms), clocks.look(); }, setup.queue);
  EXPECT_TRUE(loop.finish().ok());
  // Looks a batch apart: the flood was cut after half a second of them.
  EXPECT_LT(clocks.wall(), WallTime(1'002s));
}

}  // namespace
}  // namespace rocinante
