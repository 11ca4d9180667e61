#include "core/session/keyframe.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/core/session/session_support.h"

namespace rocinante::test {
namespace {

SessionState stateOf(const std::vector<std::string>& datagrams) {
  HandFold fold;
  for (std::size_t i = 0; i < datagrams.size(); ++i) {
    fold.fold(at(static_cast<std::int64_t>(1000 + i)), bytesOf(datagrams[i]));
  }
  return fold.state;
}

TEST(Keyframe, TellsEverySourceWithAnEmptyLineBetweenTwo) {
  const SessionState state = stateOf({"RK1 arm@a 3 12.5\njoints arm 1 2\n", "RK1 planner - -\n"});
  const std::string text = keyframeText(state);
  EXPECT_EQ(text,
            "RK1 arm@a 3 12.5 restated part=k:1/1 by=keyframe\n"
            "order arm\n"
            "joints arm 1 2\n"
            "seen arm 1000\n"
            "\n"
            "RK1 planner - - restated part=k:1/1 by=keyframe\n");
  EXPECT_EQ(keyframeDatagrams(bytesOf(text)).size(), 2U);
  EXPECT_TRUE(KeyframeReader().read(bytesOf(text), at(5000))->sameAs(state));
}

TEST(Keyframe, OfNothingIsEmpty) {
  EXPECT_EQ(keyframeText({}), "");
  EXPECT_TRUE(KeyframeReader().read({}, at(1))->sources().empty());
}

TEST(Keyframe, WhatLaterVersionsSayIsSkipped) {
  const auto told = KeyframeReader().read(
      bytesOf("RK1 arm - - restated part=k:1/1 by=keyframe shiny=1\nglow arm 5\njoints arm 1\n"
              "seen arm 7\n"),
      at(9));
  ASSERT_TRUE(told.ok()) << told.error().text();
  EXPECT_EQ(told->devices().at("arm").last_write, at(7));
}

TEST(Keyframe, IsRefusedWhereItIsNoneWithTheReason) {
  const std::pair<const char*, const char*> cases[] = {
      {"hello", "datagram 1 is not a packet"},
      {"RK1 a - -\n", "datagram 1 is not part of a keyframe"},
      {"RK1 a - - restated part=k:1/1\n", "datagram 1 is not part of a keyframe"},
      {"RK1 a - - restated part=k:1/1 by=k reset\n", "datagram 1 is not part of a keyframe"},
      {"RK1 a - - restated part=k:1/2 by=k\n", "parts are missing"},
      {"RK1 a - - restated part=k:1/1 by=k\n\nRK1 a - - restated part=k:1/1 by=k\n",
       "datagram 2 repeats a source"},
      {"RK1 a 5 - restated part=k:1/2 by=k\n\nRK1 a 4 - restated part=k:2/2 by=k\n",
       "datagram 2 contradicts one before it"},
      {"RK1 a - - restated part=k:1/1 by=k\njoints d x\n",
       "datagram 1 has a fault in its line 2: bad_number"},
      {"RK1 a - - restated part=k:1/1 by=k\norder d j\njoints d 1 2\nseen d 1\n",
       "its contents cannot be kept: order_mismatch"},
      {"RK1 a - - restated part=k:1/1 by=k\njoints d 1\n", "a device lacks its last write"},
  };
  for (const auto& [text, reason] : cases) {
    SCOPED_TRACE(text);
    const auto told = KeyframeReader().read(bytesOf(text), at(9));
    ASSERT_FALSE(told.ok());
    EXPECT_EQ(told.error().kind, ErrorKind::damaged);
    EXPECT_EQ(told.error().what, reason);
  }
}

TEST(Keyframe, CutOrChangedAnywhereIsAStateOrARefusalAndNeverMore) {
  HandFold fold;
  for (const TimedDatagram& said : randomDatagrams(4, 300)) {
    fold.fold(said.time, bytesOf(said.text));
  }
  const std::string text = keyframeText(fold.state);
  const LogTime now = at(1'000'000'000'000);
  KeyframeReader reader;
  ASSERT_TRUE(reader.read(bytesOf(text), now)->sameAs(fold.state));
  std::size_t refused = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string cut = text.substr(0, size);
    refused += reader.read(bytesOf(cut), now).ok() ? 0U : 1U;
  }
  EXPECT_GT(refused, text.size() / 2);
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = text;
    changed[random() % changed.size()] = static_cast<char>(random());
    const auto told = reader.read(bytesOf(changed), now);
    EXPECT_FALSE(told.ok() && told->restatementOpen());
  }
}

TEST(Keyframe, OfManySourcesAndDevicesIsMadeAndReadInOneWalk) {
  // S sources x D devices steps would be a hundred million here.
  HandFold fold;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = "RK1 s" + std::to_string(i) + " 1 2\njoints d" + std::to_string(i) +
                             " 1 2 3\npose e" + std::to_string(i) + " 0 0 0 0 0 0 1\n";
    fold.fold(at(1000 + i), bytesOf(text));
  }
  const std::string text = keyframeText(fold.state);
  const auto told = KeyframeReader().read(bytesOf(text), at(10'000));
  ASSERT_TRUE(told.ok()) << told.error().text();
  EXPECT_TRUE(told->sameAs(fold.state));
}

TEST(Keyframe, TheExampleOfTheDocumentIsOne) {
  std::ifstream page(std::string(ROCINANTE_SOURCE_DIR) + "/docs/log-format.md");
  std::stringstream all;
  all << page.rdbuf();
  const std::string text = all.str();
  const std::size_t section = text.find("## Keyframes");
  ASSERT_NE(section, std::string::npos);
  const std::size_t from = text.find("```\n", section) + 4;
  const std::string example = text.substr(from, text.find("```", from) - from);
  const LogTime now = at(1'770'091'520'000'000'000);
  const auto told = KeyframeReader().read(bytesOf(example), now);
  ASSERT_TRUE(told.ok()) << told.error().text();
  EXPECT_EQ(keyframeText(*told), example);
}

}  // namespace
}  // namespace rocinante::test
