#include "core/base/pattern.h"

#include <fnmatch.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace rocinante {
namespace {

TEST(Pattern, StarsAndQuestionMarksTakeAnyByte) {
  EXPECT_TRUE(patternMatches("*", ""));
  EXPECT_TRUE(patternMatches("/udp/*", "/udp/239.1.2.3:4000/cell"));
  EXPECT_TRUE(patternMatches("joint?", "joint7"));
  EXPECT_FALSE(patternMatches("joint?", "joint"));
  EXPECT_FALSE(patternMatches("", "a"));
}

TEST(Pattern, SetsTakeOneOfTheirBytes) {
  EXPECT_TRUE(patternMatches("arm[12]", "arm2"));
  EXPECT_TRUE(patternMatches("arm[0-9a]", "arma"));
  EXPECT_FALSE(patternMatches("arm[!0-9]", "arm3"));
  EXPECT_TRUE(patternMatches("arm[^0-9]", "armx"));
  EXPECT_TRUE(patternMatches("[]x]", "]"));
  EXPECT_TRUE(patternMatches("a[", "a["));
  EXPECT_FALSE(patternMatches("arm[12]", "arm"));
}

TEST(Pattern, ANameWithMarksInItMatchesItself) {
  EXPECT_TRUE(patternMatches("/udp/[ff02::1]:4000", "/udp/[ff02::1]:4000"));
  EXPECT_TRUE(patternMatches("arm[1]", "arm[1]"));
  EXPECT_TRUE(patternMatches("a\\", "a\\"));
}

TEST(Pattern, BackslashTakesTheNextByteAsItIs) {
  EXPECT_TRUE(patternMatches("a\\*", "a*"));
  EXPECT_FALSE(patternMatches("a\\*", "ab"));
  EXPECT_TRUE(patternMatches("arm\\[1\\]*", "arm[1].elbow"));
  EXPECT_FALSE(patternMatches("*a\\", "ba\\"));
}

TEST(Pattern, AnyOfNoneIsFalse) {
  EXPECT_FALSE(anyPatternMatches({}, "a"));
  const std::string patterns[] = {"x", "a*"};
  EXPECT_TRUE(anyPatternMatches(patterns, "ab"));
}

/// What topics and conditions had: POSIX fnmatch; without sets also what
/// names in cells and suites had.
RC_GTEST_PROP(Pattern, IsPosixBesideTheTextItself, ()) {
  const auto bytes = [](const char* of) {
    return rc::gen::container<std::string>(rc::gen::elementOf(std::string(of)));
  };
  const std::string pattern = *bytes("abc*?[]!^-\\/");
  const std::string text = *bytes("abc[]!^-\\/");
  if (pattern == text) RC_DISCARD("the text itself");
  RC_ASSERT(patternMatches(pattern, text) == (::fnmatch(pattern.c_str(), text.c_str(), 0) == 0));
}

}  // namespace
}  // namespace rocinante
