#include "golden/suite/suite_append.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(WithCase, KeepsEveryByteBeforeIt) {
  const std::string suite = "format = 1\r\ncell = \"c\"\r\n# comment\r\n[[case]]\r\nname = \"a\"";
  NewCase added{"b", {}};
  added.addText("at", "1\"2\\");
  added.addTexts("tags", {"x", "y"});
  const auto text = withCase(suite, added, "s.toml");
  ASSERT_TRUE(text.ok()) << text.error().text();
  EXPECT_EQ(*text, suite +
                       "\r\n\r\n[[case]]\r\nname = \"b\"\r\nat = \"1\\\"2\\\\\"\r\n"
                       "tags = [\"x\", \"y\"]\r\n");
}

TEST(WithCase, RefusesWhatWouldNotBeSound) {
  const std::string suite = "format = 1\ncell = \"c\"\n[[case]]\nname = \"a\"\n";
  EXPECT_FALSE(withCase(suite, {"a", {}}, "s.toml").ok());
  EXPECT_FALSE(withCase(suite, {"../b", {}}, "s.toml").ok());
  EXPECT_FALSE(withCase(suite, {"b", {{"samples", "3"}}}, "s.toml").ok());
  EXPECT_FALSE(
      withCase("format = 1\ncell = \"c\"\ncase = [{ name = \"a\" }]\n", {"b", {}}, "s").ok());
  EXPECT_TRUE(withCase("format = 1\ncell = \"c\"\n", {"b", {}}, "s.toml").ok());
}

}  // namespace
}  // namespace rocinante
