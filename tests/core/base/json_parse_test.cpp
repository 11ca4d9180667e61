#include "core/base/json_parse.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/process_memory.h"

namespace rocinante {
namespace {

using Tree = nlohmann::json;

std::string brackets(std::size_t count) { return std::string(count, '['); }

TEST(ParseJson, ReadsWhatJsonIs) {
  const Result<Tree> tree = parseJson<Tree>(R"({"a": [1, "\"[[[\\", {"b": null}], "c": "]"})");
  ASSERT_TRUE(tree.ok());
  EXPECT_EQ((*tree)["a"][1], "\"[[[\\");
  for (const char* broken : {"", "[", "]", "{\"", "[1, 2", "\"\\", "nonsense"}) {
    const Result<Tree> none = parseJson<Tree>(broken);
    ASSERT_FALSE(none.ok()) << broken;
    EXPECT_EQ(none.error().text(), "it is not JSON");
    EXPECT_TRUE(parseJsonOrDiscard<Tree>(broken).is_discarded());
  }
}

TEST(ParseJson, RefusesWhatExceedsALimitAndTakesWhatDoesNot) {
  const JsonLimits limits{40, 5, 3};
  EXPECT_TRUE(parseJson<Tree>("[[[1]]]", limits).ok());
  EXPECT_EQ(parseJson<Tree>("[[[[1]]]]", limits).error().text(),
            "its JSON is nested deeper than 3");
  EXPECT_EQ(parseJson<Tree>("[{\"a\":[{}]}]", limits).error().text(),
            "its JSON is nested deeper than 3");
  EXPECT_TRUE(parseJson<Tree>("[[],[],[]]", {40, 7, 3}).ok());
  EXPECT_EQ(parseJson<Tree>("[[],[],[]]", limits).error().text(),
            "its JSON has more than 5 values");
  EXPECT_EQ(parseJson<Tree>("[1,2,3,4,5]", limits).error().text(),
            "its JSON has more than 5 values");
  EXPECT_TRUE(parseJson<Tree>("[\"[[[[[,,,,,\"]", limits).ok());
  EXPECT_EQ(parseJson<Tree>(std::string(41, ' '), limits).error().text(),
            "its JSON is larger than 40 bytes");
}

TEST(ParseJson, BracketsCostNoMemory) {
  const std::string deep = brackets(48'000'000);
  std::string wide = "[";
  while (wide.size() < 48'000'000) wide += "[],";
  wide += "[]]";
  const std::uint64_t before = test::anonymousBytes();
  EXPECT_FALSE(parseJson<Tree>(deep).ok());
  EXPECT_FALSE(parseJson<Tree>(wide).ok());
  EXPECT_LT(test::anonymousBytes(), before + (std::uint64_t{1} << 20U));
}

}  // namespace
}  // namespace rocinante
