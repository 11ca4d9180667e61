#include "recorder/pieces/ring_buffer.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <string>

#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

RingBuffer::Item item(std::uint32_t number, std::string_view payload) {
  return {RingBuffer::Kind::datagram,
          logTime(1ms * number),
          number * 7,
          number % 5,
          number,
          bytesOf(payload)};
}

TEST(RingBuffer, GivesBackWhatItTook) {
  RingBuffer ring(0);
  EXPECT_TRUE(ring.empty());
  ASSERT_TRUE(ring.add(item(7, "seven")));
  const RingBuffer::Item front = ring.front();
  EXPECT_EQ(front.time, logTime(7ms));
  EXPECT_EQ(front.publish_time_ns, 49);
  EXPECT_EQ(front.flow, 2U);
  EXPECT_EQ(front.sequence, 7U);
  EXPECT_EQ(textOf(front.payload), "seven");
  ring.popFront();
  EXPECT_TRUE(ring.empty());
  EXPECT_TRUE(ring.begin() == ring.end());
}

TEST(RingBuffer, KeepsAMadePacketWithItsOctets) {
  RingBuffer ring(0);
  RingBuffer::Item octets = item(1, "octets");
  octets.made = bytesOf("a packet");
  octets.decoder = 200;
  ASSERT_TRUE(ring.add(octets));
  ASSERT_TRUE(ring.add(item(2, "more")));
  EXPECT_EQ(textOf(ring.front().payload), "octets");
  EXPECT_EQ(textOf(ring.front().made), "a packet");
  EXPECT_EQ(ring.front().decoder, 200U);
  ring.popFront();
  EXPECT_EQ(textOf(ring.front().payload), "more");
  EXPECT_TRUE(ring.front().made.empty());
}

TEST(RingBuffer, HoldsNoMoreThanItsBytes) {
  RingBuffer ring(8 * RingBuffer::kBlockBytes);
  const std::string payload(60'000, 'x');
  std::uint32_t taken = 0;
  while (ring.add(item(taken, payload))) ++taken;
  EXPECT_EQ(ring.bytes(), ring.maxBytes());
  EXPECT_GT(taken * payload.size(), 7 * RingBuffer::kBlockBytes);
  while (!ring.add(item(taken, payload))) ring.popFront();
  EXPECT_EQ(ring.bytes(), ring.maxBytes());
}

/// Compared with a plain queue, for any additions, removals and reader positions.
TEST(RingBuffer, IsAQueueWithPlaces) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    RingBuffer ring(4 * RingBuffer::kBlockBytes);
    std::deque<std::string> model;
    std::uint32_t added = 0;
    RingBuffer::Place reader = ring.begin();
    std::uint32_t read = 0;
    for (int round = 0; round < 4'000; ++round) {
      const unsigned action = random() % 8;
      if (action < 4) {
        // Includes sizes that fill a block exactly.
        const std::size_t bytes = random() % 16 == 0 ? random() % 65'508 : random() % 4'000;
        const std::string payload(bytes, static_cast<char>('a' + added % 26));
        if (ring.add(item(added, payload))) {
          model.push_back(payload);
          ++added;
        } else {
          ASSERT_EQ(ring.bytes(), ring.maxBytes());
        }
      } else if (action < 6 && !model.empty() && read > added - model.size()) {
        ASSERT_EQ(textOf(ring.front().payload), model.front());
        ring.popFront();
        model.pop_front();
      } else if (!(reader == ring.end())) {
        const std::size_t index = read - (added - model.size());
        const RingBuffer::Item here = ring.at(reader);
        ASSERT_EQ(here.sequence, read);
        ASSERT_EQ(textOf(here.payload), model[index]);
        reader = ring.after(reader);
        ++read;
      }
      ASSERT_EQ(ring.size(), model.size());
      ASSERT_EQ(ring.empty(), model.empty());
    }
    EXPECT_GT(read, 500U);
  }
}

TEST(RingBuffer, BlocksThatEndWithTheirLastByteAreLeftBehind) {
  RingBuffer ring(4 * RingBuffer::kBlockBytes);
  // 32 bytes before each payload: sixteen of these are a block.
  const std::string payload(RingBuffer::kBlockBytes / 16 - 32, 'x');
  for (std::uint32_t i = 0; i < 500; ++i) {
    ASSERT_TRUE(ring.add(item(i, payload)));
    if (i % 40 == 39) {
      while (!ring.empty()) ring.popFront();
    }
  }
  EXPECT_LE(ring.bytes(), ring.maxBytes());
}

}  // namespace
}  // namespace rocinante
