#include "core/pcap/fragment_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using Outcome = FragmentTable::Outcome;

const SocketAddress kFrom = SocketAddress::parse("10.0.0.1", 0).value();
const SocketAddress kTo = SocketAddress::parse("10.0.0.2", 0).value();
constexpr WallTime kStart{1'700'000'000s};

Bytes payloadOf(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Bytes bytes(size);
  for (std::byte& each : bytes) each = static_cast<std::byte>(random());
  return bytes;
}

Fragment part(ByteView whole, std::size_t offset, std::size_t size, std::uint32_t id = 1) {
  Fragment fragment{kFrom, kTo, id, 0, static_cast<std::uint32_t>(offset), {}, kStart, {}};
  fragment.bytes = whole.subspan(offset, size);
  fragment.more = offset + size < whole.size();
  return fragment;
}

TEST(FragmentTable, PutsTwoTogetherInEitherOrder) {
  const Bytes whole = payloadOf(20, 1);
  for (const bool last_first : {false, true}) {
    FragmentTable table;
    EXPECT_EQ(table.add(last_first ? part(whole, 8, 12) : part(whole, 0, 8)), Outcome::waiting);
    EXPECT_EQ(table.waiting(), 1U);
    EXPECT_EQ(table.add(last_first ? part(whole, 0, 8) : part(whole, 8, 12)), Outcome::whole);
    EXPECT_TRUE(std::ranges::equal(table.whole(), whole));
    EXPECT_EQ(table.waiting(), 0U);
    EXPECT_EQ(table.bytesHeld(), 0U);
    EXPECT_EQ(table.incomplete(), 0U);
  }
}

TEST(FragmentTable, AnythingThatIsNotTheSamePacketStandsApart) {
  const Bytes whole = payloadOf(16, 1);
  Fragment second = part(whole, 8, 8);
  for (int what = 0; what < 5; ++what) {
    SCOPED_TRACE(what);
    FragmentTable table;
    ASSERT_EQ(table.add(part(whole, 0, 8)), Outcome::waiting);
    Fragment other = second;
    if (what == 0) other.id = 2;
    if (what == 1) other.source.address[3] = 9;
    if (what == 2) other.destination.address[0] = 9;
    if (what == 3) other.link = 5;
    if (what == 4) other.source.is_ipv6 = other.destination.is_ipv6 = true;
    EXPECT_EQ(table.add(other), Outcome::waiting);
    EXPECT_EQ(table.waiting(), 2U);
  }
}

TEST(FragmentTable, WhatNoFragmentCanBeIsMalformed) {
  const Bytes whole = payloadOf(70'000, 1);
  FragmentTable table;
  Fragment odd = part(whole, 0, 7);
  EXPECT_EQ(table.add(odd), Outcome::malformed);
  Fragment empty = part(whole, 8, 0);
  EXPECT_EQ(table.add(empty), Outcome::malformed);
  empty.more = false;
  EXPECT_EQ(table.add(empty), Outcome::malformed);
  Fragment beyond = part(whole, 65'528, 8);
  EXPECT_EQ(table.add(beyond), Outcome::malformed);
  Fragment unaligned = part(whole, 4, 8);
  EXPECT_EQ(table.add(unaligned), Outcome::malformed);
  EXPECT_EQ(table.waiting(), 0U);
  EXPECT_EQ(table.add(part(whole, 65'520, 8)), Outcome::waiting);
}

TEST(FragmentTable, ContradictionsMakeThePacketNothing) {
  const Bytes whole = payloadOf(64, 1);
  const Bytes other = payloadOf(64, 2);
  const auto ending = [](Fragment fragment) {
    fragment.more = false;
    return fragment;
  };
  const std::vector<std::pair<Fragment, Fragment>> contradictions{
      {part(whole, 0, 16), part(other, 0, 16)},            // other bytes
      {part(whole, 0, 16), part(whole, 8, 16)},            // half of it is new
      {part(whole, 8, 16), part(whole, 0, 16)},            //
      {part(whole, 16, 8), part(whole, 8, 24)},            // around it
      {part(whole, 48, 16), ending(part(whole, 32, 16))},  // two ends
      {ending(part(whole, 32, 16)), part(whole, 48, 8)},   // beyond the end
      {part(whole, 40, 8), ending(part(whole, 24, 8))},    // the end before what came
  };
  for (std::size_t i = 0; i < contradictions.size(); ++i) {
    SCOPED_TRACE(i);
    FragmentTable table;
    EXPECT_EQ(table.add(contradictions[i].first), Outcome::waiting);
    EXPECT_EQ(table.add(contradictions[i].second), Outcome::waiting);
    EXPECT_EQ(table.incomplete(), 1U);
    // No later fragment repairs it.
    for (std::size_t at = 0; at < 64; at += 8) {
      EXPECT_EQ(table.add(part(whole, at, 8)), Outcome::waiting);
    }
    table.clear();
    EXPECT_EQ(table.incomplete(), 1U);
    EXPECT_EQ(table.bytesHeld(), 0U);
  }
}

TEST(FragmentTable, GivesUpAfterItsPatienceAlsoWhenTheClockIsSet) {
  const Bytes whole = payloadOf(16, 1);
  for (const Nanoseconds passed : {Nanoseconds(2'001ms), Nanoseconds(-1h)}) {
    FragmentTable table;
    ASSERT_EQ(table.add(part(whole, 0, 8)), Outcome::waiting);
    Fragment late = part(whole, 8, 8);
    late.time += passed;
    EXPECT_EQ(table.add(late), Outcome::waiting);
    EXPECT_EQ(table.incomplete(), 1U);
  }
  FragmentTable table;
  ASSERT_EQ(table.add(part(whole, 0, 8)), Outcome::waiting);
  Fragment in_time = part(whole, 8, 8);
  in_time.time += 1'999ms;
  EXPECT_EQ(table.add(in_time), Outcome::whole);
}

TEST(FragmentTable, ForgetsTheOldestWhenThereIsNoRoom) {
  const Bytes whole = payloadOf(16, 1);
  FragmentTable table({.bytes = 1U << 20U, .packets = 3});
  for (std::uint32_t id = 1; id <= 4; ++id) table.add(part(whole, 0, 8, id));
  EXPECT_EQ(table.incomplete(), 1U);
  EXPECT_EQ(table.add(part(whole, 8, 8, 2)), Outcome::whole);
  EXPECT_EQ(table.add(part(whole, 8, 8, 1)), Outcome::waiting);
}

struct Piece {
  std::size_t packet;
  Fragment fragment;
};

/// Packets of every size, cut anywhere, sent in any order, some twice: all are reassembled.
TEST(FragmentTable, AnyOrderAndRepetitionGivesThePacketsBack) {
  std::mt19937 random(1996);
  for (int round = 0; round < 300; ++round) {
    std::vector<Bytes> packets;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < 1 + random() % 6; ++i) {
      packets.push_back(payloadOf(9 + random() % (round % 10 == 0 ? 65'500 : 3'000),
                                  static_cast<unsigned>(random())));
    }
    for (std::size_t i = 0; i < packets.size(); ++i) {
      const ByteView whole = packets[i];
      for (std::size_t at = 0; at < whole.size();) {
        const std::size_t size = std::min(whole.size() - at, (1 + random() % 180) * 8);
        // In one piece it would not be a fragment.
        const std::size_t kept = size == whole.size() ? 8 : size;
        pieces.push_back({i, part(whole, at, kept, static_cast<std::uint32_t>(i))});
        at += kept;
      }
    }
    // After the packet is whole, a repeated fragment would begin a new one.
    std::vector<std::size_t> missing(packets.size());
    for (const Piece& each : pieces) ++missing[each.packet];
    std::ranges::shuffle(pieces, random);
    FragmentTable table;
    std::size_t whole = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Fragment fragment = pieces[i].fragment;
      fragment.time += 1us * static_cast<int>(i);
      const bool last = --missing[pieces[i].packet] == 0;
      const Outcome outcome = table.add(fragment);
      ASSERT_EQ(outcome, last ? Outcome::whole : Outcome::waiting);
      if (last) {
        ++whole;
        ASSERT_TRUE(std::ranges::equal(table.whole(), packets[pieces[i].packet]));
      } else if (random() % 4 == 0) {
        ASSERT_EQ(table.add(fragment), Outcome::waiting);
      }
    }
    EXPECT_EQ(whole, packets.size());
    EXPECT_EQ(table.bytesHeld(), 0U);
    EXPECT_EQ(table.incomplete(), 0U);
  }
}

/// Malicious fragments: only complete packets are returned, within the limits.
TEST(FragmentTable, HostileFragmentsStayWithinTheBounds) {
  std::mt19937 random(7);
  const Bytes bytes = payloadOf(66'000, 5);
  const FragmentTable::Limits limits{.bytes = 200'000, .packets = 20};
  FragmentTable table(limits);
  WallTime now = kStart;
  std::uint64_t whole = 0;
  for (int i = 0; i < 60'000; ++i) {
    Fragment fragment{kFrom, kTo, static_cast<std::uint32_t>(random() % 40), 0, 0, {}, now, {}};
    fragment.offset =
        static_cast<std::uint32_t>(random() % 100 < 90 ? random() % 8 * 8 : random() % 70'000);
    fragment.bytes = ByteView(bytes).subspan(
        fragment.offset % 66'000 / 2, random() % 100 < 90 ? random() % 3 * 8 : random() % 30'000);
    fragment.more = random() % 4 != 0;
    now += Nanoseconds(random() % 20'000'000);
    if (random() % 1'000 == 0) now -= 1h;
    if (table.add(fragment) == Outcome::whole) {
      ++whole;
      ASSERT_LE(table.whole().size(), 65'535U);
    }
    ASSERT_LE(table.bytesHeld(), limits.bytes + 70'000);
    ASSERT_LE(table.waiting(), limits.packets);
  }
  EXPECT_GT(whole, 0U);
  EXPECT_GT(table.incomplete(), 0U);
  table.clear();
  EXPECT_EQ(table.bytesHeld(), 0U);
}

}  // namespace
}  // namespace rocinante
