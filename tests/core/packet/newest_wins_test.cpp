// docs/packet-format.md, section "Newest wins": which packets are applied, and what is counted.
#include <gtest/gtest.h>

#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::TextFold;

std::string packet(const std::string& header, const std::string& value) {
  return "RK1 " + header + "\njoints arm " + value + "\n";
}

class NewestWins : public ::testing::Test {
 protected:
  double value() const { return fold_.device("arm").joints->value.at(0); }
  const SourceCounts& counts() const { return fold_.counts("me"); }
  const SourceState& source() const { return fold_.state.sources().find("me")->second; }
  TextFold fold_;
};

TEST_F(NewestWins, ALatePacketIsCountedAndDroppedWhole) {
  EXPECT_EQ(fold_.fold(1, packet("me 7 10", "7")), Applied::yes);
  EXPECT_EQ(fold_.fold(2, packet("me 9 11", "9")), Applied::yes);
  EXPECT_EQ(counts().gap, 1U);
  EXPECT_EQ(fold_.fold(3, packet("me 8 12", "8")), Applied::late);
  EXPECT_EQ(value(), 9);
  EXPECT_EQ(fold_.device("arm").last_write, test::atSeconds(2));
  EXPECT_EQ(source().highest_sequence, 9U);
  EXPECT_EQ(source().time_ns, 11'000'000'000);
  EXPECT_EQ(counts().late, 1U);
  EXPECT_EQ(counts().duplicates, 0U);
  EXPECT_EQ(counts().gap, 0U) << "the missing one came after all";
  EXPECT_EQ(fold_.fold(4, packet("me 8 12", "8")), Applied::late);
  EXPECT_EQ(fold_.fold(4, packet("me 9 12", "8")), Applied::late);
  EXPECT_EQ(counts().late, 3U);
  EXPECT_EQ(counts().duplicates, 2U);
  EXPECT_EQ(counts().gap, 0U);
  EXPECT_EQ(counts().packets, 2U);
}

TEST_F(NewestWins, WhatCameBeforeTheFirstPacketSeenIsNoGap) {
  fold_.fold(1, packet("me 100 -", "1"));
  EXPECT_EQ(fold_.fold(1, packet("me 99 -", "2")), Applied::late);
  EXPECT_EQ(counts().gap, 0U);
  EXPECT_EQ(counts().duplicates, 1U);
}

TEST_F(NewestWins, SixtyFourLowerIsLateAndOneMoreARestart) {
  fold_.fold(1, packet("me 1000 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me 936 -", "2")), Applied::late);
  EXPECT_EQ(counts().restarts, 0U);
  EXPECT_EQ(fold_.fold(3, packet("me 935 -", "3")), Applied::yes);
  EXPECT_EQ(value(), 3);
  EXPECT_EQ(counts().restarts, 1U);
  EXPECT_EQ(source().highest_sequence, 935U);
  EXPECT_EQ(fold_.fold(4, packet("me 936 -", "4")), Applied::yes);
  EXPECT_EQ(counts().gap, 0U);
}

TEST_F(NewestWins, SequenceZeroIsARestartAlsoAfterZero) {
  fold_.fold(1, packet("me 3 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me 0 -", "2")), Applied::yes);
  EXPECT_EQ(fold_.fold(3, packet("me 0 -", "3")), Applied::yes);
  EXPECT_EQ(value(), 3);
  EXPECT_EQ(counts().restarts, 2U);
}

TEST_F(NewestWins, AnotherRunIsARestartAndChangesNothingElse) {
  fold_.fold(1, packet("me@a 50 -", "1"));
  fold_.fold(1, "RK1 me@a 51 -\npose arm 1 2 3 0 0 0 1\n");
  EXPECT_EQ(fold_.fold(2, packet("me@b 40 -", "2")), Applied::yes);
  EXPECT_EQ(value(), 2);
  EXPECT_TRUE(fold_.device("arm").pose);
  EXPECT_EQ(source().run, "b");
  EXPECT_EQ(source().highest_sequence, 40U);
  EXPECT_EQ(counts().restarts, 1U);
  EXPECT_EQ(counts().gap, 0U);
}

TEST_F(NewestWins, NoSequenceIsAlwaysAppliedAndNeverAGap) {
  fold_.fold(1, packet("me 5 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me - -", "2")), Applied::yes);
  EXPECT_EQ(value(), 2);
  EXPECT_EQ(source().highest_sequence, 5U);
  EXPECT_EQ(fold_.fold(3, packet("me 5 -", "3")), Applied::late);
  EXPECT_EQ(fold_.fold(4, packet("me 6 -", "4")), Applied::yes);
  EXPECT_EQ(counts().gap, 0U);
}

TEST_F(NewestWins, TheTimeIsThatOfTheLastPacketApplied) {
  fold_.fold(1, packet("me 5 2.5", "1"));
  EXPECT_EQ(source().time_ns, 2'500'000'000);
  fold_.fold(2, packet("me 6 -", "2"));
  EXPECT_EQ(source().time_ns, std::nullopt);
}

TEST_F(NewestWins, SomeoneElseRestatingIsAppliedWhenNotBelowTheHighest) {
  fold_.fold(1, packet("me@a 5 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me@a 4 - by=r", "4")), Applied::late);
  EXPECT_EQ(fold_.fold(2, packet("me@a 0 - by=r", "4")), Applied::late);
  EXPECT_EQ(value(), 1);
  EXPECT_EQ(fold_.fold(3, packet("me@a 5 - by=r", "5")), Applied::yes);
  EXPECT_EQ(value(), 5);
  EXPECT_EQ(fold_.fold(4, packet("me@a 9 - by=r", "9")), Applied::yes);
  EXPECT_EQ(source().highest_sequence, 9U);
  EXPECT_EQ(fold_.fold(4, packet("me@a - - by=r", "-1")), Applied::yes);
  EXPECT_EQ(fold_.fold(5, packet("me@a 10 -", "10")), Applied::yes);
  EXPECT_EQ(counts().gap, 0U);
  EXPECT_EQ(counts().late, 0U);
  EXPECT_EQ(counts().duplicates, 0U);
  EXPECT_EQ(counts().restarts, 0U);
  EXPECT_EQ(counts().packets, 2U);
  EXPECT_EQ(counts().by_others, 3U);
}

TEST_F(NewestWins, SomeoneElseMayRestateANewerRun) {
  fold_.fold(1, packet("me@a 500 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me@b 5 - by=r", "2")), Applied::yes);
  EXPECT_EQ(source().run, "b");
  EXPECT_EQ(counts().restarts, 0U);
}

TEST_F(NewestWins, ResetForgetsTheMemoryOfSequence) {
  fold_.fold(1, packet("me 50 -", "1"));
  EXPECT_EQ(fold_.fold(2, packet("me 20 - restated part=s:1/2 by=player reset", "2")),
            Applied::yes);
  EXPECT_EQ(source().highest_sequence, 20U);
  EXPECT_EQ(fold_.fold(2, packet("me 20 - restated part=s:2/2 by=player reset", "3")),
            Applied::yes);
  EXPECT_EQ(fold_.fold(3, packet("me 21 -", "4")), Applied::yes);
  EXPECT_EQ(counts().gap, 0U);
  EXPECT_EQ(counts().restarts, 0U);
  fold_.fold(4, packet("me - - part=t:1/1 by=player reset", "5"));
  EXPECT_EQ(source().highest_sequence, std::nullopt);
}

TEST_F(NewestWins, ALossAfterARelayIsJudgedOnItsOwnCount) {
  fold_.fold(1, packet("me 5 - via=r:100", "1"));
  fold_.fold(2, packet("me 9 - via=r:101", "2"));
  EXPECT_EQ(counts().gap, 0U);
  const RelayCounts& relay = fold_.state.relays().find("r")->second;
  EXPECT_EQ(relay.gap, 0U);
  fold_.fold(3, packet("you 1 - via=r:104", "3"));
  EXPECT_EQ(relay.gap, 2U);
  fold_.fold(4, packet("you 2 - via=r:103", "4"));
  EXPECT_EQ(relay.gap, 1U);
  fold_.fold(5, packet("you 3 - via=r:0", "5"));
  EXPECT_EQ(relay.restarts, 1U);
  EXPECT_EQ(relay.packets, 5U);
}

TEST_F(NewestWins, FaultsAreCountedBySource) {
  fold_.fold(1, "RK1 me 1 -\njoints arm x\nwave\nwave\npose arm 0 0 0 0 0 0 2\n");
  const auto count = [&](PacketFault fault) {
    return counts().faults[static_cast<std::size_t>(fault)];
  };
  EXPECT_EQ(count(PacketFault::bad_number), 1U);
  EXPECT_EQ(count(PacketFault::unknown_statement), 2U);
  EXPECT_EQ(count(PacketFault::unnormalised_quaternion), 1U);
  EXPECT_TRUE(fold_.device("arm").pose);
}

TEST_F(NewestWins, EventsAreHandedOverOnceAndNeverWhenRestatedByOthers) {
  fold_.fold(1, "RK1 me 1 -\nevent \"a\"\n");
  fold_.fold(2, "RK1 me 1 - by=relay\nevent \"b\"\n");
  fold_.fold(3, "RK1 me 1 -\nevent \"late\"\n");
  const std::vector<Event> events = fold_.state.takeEvents();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].text, "a");
  EXPECT_EQ(events[0].source, "me");
  EXPECT_EQ(events[0].time, test::atSeconds(1));
  EXPECT_TRUE(fold_.state.takeEvents().empty());
}

TEST_F(NewestWins, ACopyGoesItsOwnWay) {
  fold_.fold(1, packet("me 1 -", "1"));
  TextFold other;
  other.state = fold_.state;
  fold_.fold(2, packet("me 2 -", "2"));
  EXPECT_EQ(other.device("arm").joints->value.at(0), 1);
  other.fold(3, packet("me 9 -", "3"));
  EXPECT_EQ(value(), 2);
  EXPECT_EQ(source().highest_sequence, 2U);
  EXPECT_EQ(counts().packets, 2U);
  SessionState moved = std::move(other.state);
  other.state = SessionState();
  other.fold(4, packet("me 1 -", "4"));
  EXPECT_EQ(moved.devices().at("arm").joints->value.at(0), 3);
  EXPECT_EQ(moved.counts().at("me").packets, 2U);
}

}  // namespace
}  // namespace rocinante
