#include "core/relay/through.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(Through, ReadsTheWordOfTheHeaderAlone) {
  EXPECT_EQ(throughOf("# c\n\nRK1 a - - restated through=x,y by=z\n"), "x,y");
  EXPECT_EQ(throughOf("RK1 a - -\nevent \"through=x\"\n"), "");
  EXPECT_EQ(throughOf("RK1 a - - notthrough=x\n"), "");
  EXPECT_EQ(throughOf(""), "");
}

TEST(Through, KnowsALoop) {
  EXPECT_FALSE(hasPassed("", "a"));
  EXPECT_FALSE(hasPassed("ab,b", "a"));
  EXPECT_TRUE(hasPassed("b,a", "a"));
  EXPECT_FALSE(isTooLong(""));
  EXPECT_FALSE(isTooLong("1,2,3,4,5,6,7,8"));
  EXPECT_TRUE(isTooLong("1,2,3,4,5,6,7,8,9"));
  EXPECT_TRUE(isTooLong(",,,,,,,,,,"));
}

TEST(Through, AddsANameAndChangesNothingElse) {
  EXPECT_EQ(withThrough("RK1 a - -", "n"), "RK1 a - - through=n");
  EXPECT_EQ(withThrough("#x\r\nRK1 a - -\r\nremove d", "n"),
            "#x\r\nRK1 a - - through=n\r\nremove d");
  EXPECT_EQ(withThrough("RK1 a - - through=m by=b\n", "n"), "RK1 a - - through=m,n by=b\n");
  EXPECT_EQ(throughWith("", "n"), "n");
  EXPECT_EQ(throughWith("m", "n"), "m,n");
}

}  // namespace
}  // namespace rocinante
