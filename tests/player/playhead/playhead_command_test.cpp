#include "player/playhead/playhead_command.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using Kind = PlayheadCommand::Kind;

Result<PlayheadCommand> parse(std::string_view line) {
  return parsePlayheadCommand(line, LogTime(10s), LogTime(20s));
}

TEST(PlayheadCommand, ReadsWhatIsDocumented) {
  EXPECT_EQ(parse("play")->kind, Kind::play);
  EXPECT_EQ(parse("  pause\t")->kind, Kind::pause);
  EXPECT_EQ(parse("toggle\r")->kind, Kind::toggle);
  EXPECT_EQ(parse("step")->count, 1U);
  EXPECT_EQ(parse("step 17")->count, 17U);
  EXPECT_EQ(parse("back 0.5s")->kind, Kind::move);
  EXPECT_EQ(parse("back 0.5s")->duration, -500ms);
  EXPECT_EQ(parse("seek 2.5")->from, LogTime(12'500ms));
  EXPECT_EQ(parse("seek -1s")->from, LogTime(19s));
  EXPECT_EQ(parse("loop 1 2s")->until, LogTime(12s));
  EXPECT_EQ(parse("loop off")->kind, Kind::loop_off);
  EXPECT_EQ(parse("speed 3/2")->speed, PlaybackSpeed::parse("1.5").value());
  EXPECT_EQ(parse("ack 3")->count, 3U);
}

TEST(PlayheadCommand, RefusesEverythingElseInOneSentence) {
  for (const char* line : {"",
                           " ",
                           "Play",
                           "play now",
                           "step 0",
                           "step -1",
                           "step 1.5",
                           "step 1000001",
                           "step x",
                           "step 1 2",
                           "back -1s",
                           "seek",
                           "seek x",
                           "seek 1 2",
                           "speed 0",
                           "speed 1001",
                           "speed nan",
                           "loop",
                           "loop 1",
                           "loop 2 1",
                           "loop on",
                           "ack",
                           "ack -1",
                           "quit now",
                           "seek 99999999999999999999s",
                           "step 18446744073709551616"}) {
    SCOPED_TRACE(line);
    const auto command = parse(line);
    ASSERT_FALSE(command.ok());
    EXPECT_FALSE(command.error().what.empty());
    EXPECT_EQ(command.error().what.find('\n'), std::string::npos);
  }
  EXPECT_FALSE(parse(std::string(257, 'x')).ok());
}

TEST(PlayheadCommand, NoiseIsAnsweredInPlainText) {
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string line = i % 2 == 0 ? "" : "seek ";
    for (std::size_t n = random() % 30; n > 0; --n) line += static_cast<char>(random());
    const auto command = parse(line);
    if (command.ok()) continue;
    for (const char each : command.error().text()) {
      EXPECT_TRUE(static_cast<unsigned char>(each) >= ' ' && each != '\x7f');
    }
  }
}

}  // namespace
}  // namespace rocinante
