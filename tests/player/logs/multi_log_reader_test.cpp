#include "player/logs/multi_log_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/player/logs/written_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::writeLog;
using testing::ElementsAre;

std::vector<std::string> payloads(MultiLogReader& logs) {
  std::vector<std::string> found;
  while (true) {
    const auto message = logs.next().value();
    if (!message) return found;
    found.emplace_back(textOf(message->payload));
  }
}

TEST(MultiLogReader, OrdersByTimeAndThenByPlaceAmongTheArguments) {
  const test::TemporaryFolder folder;
  const auto a = writeLog(folder / "a", {{1s, "a1"}, {2s, "a2"}, {2s, "a2'"}, {9s, "a9"}});
  const auto b = writeLog(folder / "b", {{2s, "b2"}, {3s, "b3"}});
  auto ab = MultiLogReader::open({a, b}).value();
  ASSERT_TRUE(ab.seek(TapePosition{}, MultiLogReader::Which::captured).ok());
  EXPECT_THAT(payloads(ab), ElementsAre("a1", "a2", "a2'", "b2", "b3", "a9"));
  auto ba = MultiLogReader::open({b, a}).value();
  ASSERT_TRUE(ba.seek(TapePosition{}, MultiLogReader::Which::captured).ok());
  EXPECT_THAT(payloads(ba), ElementsAre("a1", "b2", "a2", "a2'", "b3", "a9"));
  EXPECT_EQ(ab.start(), LogTime(1s));
  EXPECT_EQ(ab.end(), LogTime(9s));
}

TEST(MultiLogReader, SeeksInAllLogsAndBack) {
  const test::TemporaryFolder folder;
  const auto a = writeLog(folder / "a", {{1s, "a1"}, {2s, "a2"}});
  const auto b = writeLog(folder / "b", {{2s, "b2"}, {3s, "b3"}});
  auto logs = MultiLogReader::open({a, b}).value();
  for (int turn = 0; turn < 2; ++turn) {
    ASSERT_TRUE(logs.seek(TapePosition::at(LogTime(2s)), MultiLogReader::Which::captured).ok());
    EXPECT_THAT(payloads(logs), ElementsAre("a2", "b2", "b3"));
  }
  ASSERT_TRUE(logs.seek(TapePosition::at(LogTime(3s + 1ns)), MultiLogReader::Which::captured).ok());
  EXPECT_THAT(payloads(logs), ElementsAre());
}

TEST(MultiLogReader, OnlyCapturedMessagesArePlayedAndRestatementsAreFoldedToo) {
  const test::TemporaryFolder folder;
  const auto a = writeLog(folder / "a", {{1s, "captured"},
                                         {2s, "restated", "/rocinante/restated/udp/1/a"},
                                         {3s, "keyframe", "/rocinante/keyframe"}});
  auto logs = MultiLogReader::open({a}).value();
  ASSERT_TRUE(logs.seek(TapePosition{}, MultiLogReader::Which::captured).ok());
  EXPECT_THAT(payloads(logs), ElementsAre("captured"));
  ASSERT_TRUE(logs.seek(TapePosition{}, MultiLogReader::Which::folded).ok());
  EXPECT_THAT(payloads(logs), ElementsAre("captured", "restated"));
}

TEST(MultiLogReader, SaysWhichLogCannotBeOpened) {
  const test::TemporaryFolder folder;
  const auto a = writeLog(folder / "a", {{1s, "a1"}});
  const auto logs = MultiLogReader::open({a, folder / "none"});
  ASSERT_FALSE(logs.ok());
  EXPECT_EQ(logs.error().kind, ErrorKind::not_found);
  EXPECT_NE(logs.error().where.find("none"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
