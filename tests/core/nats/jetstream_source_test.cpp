#include "core/nats/jetstream_source.h"

#include <gtest/gtest.h>

#include "tests/support/nats_server.h"

namespace rocinante {
namespace {

using test::NatsServer;
using test::StreamAdministrator;

struct Read {
  std::vector<std::string> payloads;
  std::vector<WallTime> times;
};

/// Receives `count` datagrams; fails the test after 60 s.
Read readFrom(DatagramSource& source, std::size_t count) {
  Read read;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (read.payloads.size() < count) {
    if (std::chrono::steady_clock::now() > give_up) {
      ADD_FAILURE() << "only " << read.payloads.size() << " messages came";
      break;
    }
    const auto batch = source.receive();
    if (!batch) {
      ADD_FAILURE() << batch.error().text();
      break;
    }
    for (const ReceivedDatagram& each : *batch) {
      read.payloads.emplace_back(textOf(each.payload));
      read.times.push_back(each.kernel_time);
    }
    if (batch->empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return read;
}

std::vector<std::string> numbers(int from, int until) {
  std::vector<std::string> texts;
  for (int i = from; i < until; ++i) texts.push_back("message " + std::to_string(i));
  return texts;
}

class JetStream : public testing::Test {
 protected:
  void SetUp() override {
    ROCINANTE_NEEDS_NATS_SERVER();
    server_.emplace(std::vector<std::string>{"-js"});
    administrator_.emplace(*server_);
    administrator_->add("CELLS", "cell1.>");
  }
  void publish(int from, int until) {
    for (const std::string& each : numbers(from, until)) administrator_->publish("cell1.arm", each);
  }
  Endpoint at(const std::string& options = "") {
    return Endpoint::parse(server_->streamAt("CELLS") + options).value();
  }
  std::unique_ptr<DatagramSource> resume() {
    return openJetStream(at(), StreamReading::resuming).value();
  }

  std::optional<NatsServer> server_;
  std::optional<StreamAdministrator> administrator_;
};

TEST_F(JetStream, GoesOnBehindWhatWasConfirmed) {
  publish(0, 100);
  {
    const auto first = resume();
    EXPECT_EQ(readFrom(*first, 100).payloads, numbers(0, 100));
    first->confirm(60);
  }
  publish(100, 120);
  // The server would send 60 to 99 again only after a minute.
  const auto second = resume();
  EXPECT_EQ(readFrom(*second, 60).payloads, numbers(60, 120));
  const auto said = second->maintain();
  ASSERT_TRUE(said);
  EXPECT_NE(said->find("resumes after message 60 of the stream, which has 1 to 120"), said->npos)
      << *said;
  EXPECT_EQ(second->dropped(), 0U);
}

TEST_F(JetStream, WithoutAConfirmationItBeginsAgain) {
  publish(0, 10);
  { EXPECT_EQ(readFrom(*resume(), 10).payloads, numbers(0, 10)); }
  EXPECT_EQ(readFrom(*resume(), 10).payloads, numbers(0, 10));
}

TEST_F(JetStream, WhatWasGoneBeforeTheFirstRecordingIsNoLoss) {
  publish(0, 20);
  administrator_->purgeBefore("CELLS", 16);
  for (int reader = 0; reader < 2; ++reader) {
    const auto source = resume();
    EXPECT_EQ(readFrom(*source, 5).payloads, numbers(15, 20));
    EXPECT_EQ(source->dropped(), 0U);
  }
}

TEST_F(JetStream, CountsWhatIsGoneFromTheStream) {
  publish(0, 10);
  {
    const auto first = resume();
    readFrom(*first, 10);
    first->confirm(10);
  }
  publish(10, 30);
  administrator_->purgeBefore("CELLS", 16);  // 10 to 14 are gone
  administrator_->erase("CELLS", 21);        // 20 too
  const auto second = resume();
  auto expected = numbers(15, 30);
  expected.erase(expected.begin() + 5);
  EXPECT_EQ(readFrom(*second, 14).payloads, expected);
  EXPECT_EQ(second->dropped(), 6U);
}

TEST_F(JetStream, TimesAreThoseOfTheStream) {
  const auto before = std::chrono::system_clock::now();
  publish(0, 5);
  const auto after = std::chrono::system_clock::now();
  const Read read = readFrom(*resume(), 5);
  ASSERT_EQ(read.times.size(), 5U);
  EXPECT_GE(read.times.front(), before);
  EXPECT_LE(read.times.back(), after);
  EXPECT_TRUE(std::is_sorted(read.times.begin(), read.times.end()));
}

TEST_F(JetStream, BeginsWhereFromSays) {
  publish(0, 10);
  // In the first tenth of a second, which libnats 3.4 writes wrongly.
  WallTime middle;
  do {
    middle = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
  } while (middle - std::chrono::floor<std::chrono::seconds>(middle) >=
           std::chrono::milliseconds(90));
  publish(10, 20);
  const auto by_number = openJetStream(at("?from=6&durable=a"), StreamReading::resuming).value();
  EXPECT_EQ(readFrom(*by_number, 15).payloads, numbers(5, 20));
  Endpoint by_time = at("?durable=b");
  by_time.nats.from_time = middle;
  EXPECT_EQ(readFrom(*openJetStream(by_time, StreamReading::resuming).value(), 10).payloads,
            numbers(10, 20));
}

TEST_F(JetStream, APassingReaderMovesNothing) {
  publish(0, 10);
  const auto passing = openJetStream(at("?from=4"), StreamReading::passing).value();
  const auto newest = openJetStream(at(), StreamReading::passing).value();
  EXPECT_EQ(readFrom(*passing, 7).payloads, numbers(3, 10));
  publish(10, 12);
  EXPECT_EQ(readFrom(*newest, 2).payloads, numbers(10, 12));
  EXPECT_EQ(readFrom(*resume(), 12).payloads, numbers(0, 12));
}

TEST_F(JetStream, ContinuesAfterTheServerWasKilled) {
  publish(0, 50);
  const auto source = resume();
  EXPECT_EQ(readFrom(*source, 50).payloads, numbers(0, 50));
  source->confirm(50);
  administrator_.reset();
  server_->kill();
  server_->start();
  administrator_.emplace(*server_);
  publish(50, 80);
  EXPECT_EQ(readFrom(*source, 30).payloads, numbers(50, 80));
  EXPECT_EQ(source->dropped(), 0U);
}

TEST_F(JetStream, SaysWhatIsWrong) {
  const auto here = Endpoint::parse(server_->streamAt("NONE")).value();
  const auto missing = openJetStream(here, StreamReading::resuming);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::not_found);
  administrator_->addPullConsumer("CELLS", "theirs");
  const auto foreign = openJetStream(at("?durable=theirs"), StreamReading::resuming);
  ASSERT_FALSE(foreign.ok());
  EXPECT_EQ(foreign.error().what,
            "the durable theirs of the stream was made by another program: choose another with "
            "durable=NAME");
  const auto first = resume();
  const auto second = openJetStream(at(), StreamReading::resuming);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().what,
            "another reader has the durable rocinante: choose another with durable=NAME");
  const NatsServer plain;
  const auto off =
      openJetStream(Endpoint::parse(plain.streamAt("CELLS")).value(), StreamReading::resuming);
  ASSERT_FALSE(off.ok());
  EXPECT_NE(off.error().what.find("keeps no streams: JetStream is off"), std::string::npos)
      << off.error().what;
}

}  // namespace
}  // namespace rocinante
