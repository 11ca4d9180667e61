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

TEST(ParseViewScript, NothingIsNoFault) {
  EXPECT_TRUE(parseViewScript("", "s")->empty());
  EXPECT_TRUE(parseViewScript("# only words\n\n", "s")->empty());
}

}  // namespace
}  // namespace rocinante
