#include "viewer/ui/program/view_script.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(ParseViewScript, ReadsCommandsWordsAndLines) {
  const auto commands =
      parseViewScript("# a tour\n\ncamera overview\n  orbit 10  -4.5 # turn\r\nfit", "s");
  ASSERT_TRUE(commands.ok());
  ASSERT_EQ(commands->size(), 3U);
  EXPECT_EQ((*commands)[0].name, "camera");
  EXPECT_EQ((*commands)[0].line, 3);
  EXPECT_EQ((*commands)[1].words, (std::vector<std::string>{"10", "-4.5"}));
  EXPECT_EQ((*commands)[2].line, 5);
}

TEST(ParseViewScript, FaultsNameTheLine) {
  EXPECT_EQ(parseViewScript("fit\ndance", "s.txt").error().text(),
            "unknown command `dance` (s.txt:2)");
  EXPECT_EQ(parseViewScript("orbit 1", "s.txt").error().text(),
            "`orbit` takes 2 words, not 1 (s.txt:1)");
}

TEST(ParseViewScript, FramesAreDrawnOneAfterAnother) {
  const auto commands = parseViewScript("frame-at 0s\nframe-at 1.000000001s", "s");
  ASSERT_TRUE(commands.ok());
  EXPECT_EQ(*(*commands)[1].at, Nanoseconds(1'000'000'001));
  EXPECT_EQ(parseViewScript("frame-at 1s\nframe-at 1s", "s").error().text(),
            "`1s` must be later than the frame before it (s:2)");
  EXPECT_EQ(parseViewScript("frame-at -1s", "s").error().text(),
            "`-1s` must be from 0s to 24h (s:1)");
  EXPECT_EQ(parseViewScript("frame-at 25h", "s").error().text(),
            "`25h` must be from 0s to 24h (s:1)");
  EXPECT_FALSE(parseViewScript("frame-at soon", "s").ok());
}

TEST(ParseViewScript, NothingIsNoFault) {
  EXPECT_TRUE(parseViewScript("", "s")->empty());
  EXPECT_TRUE(parseViewScript("# only words\n\n", "s")->empty());
}

}  // namespace
}  // namespace rocinante
