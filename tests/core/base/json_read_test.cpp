#include "core/base/json_read.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>

namespace rocinante {
namespace {

enum class Size { small, large, huge };

std::string_view nameOf(Size size) {
  return size == Size::small ? "small" : size == Size::large ? "large" : "huge";
}

using OrderedTree = nlohmann::ordered_json;

const OrderedTree& example() {
  static const OrderedTree kExample = OrderedTree::parse(
      R"({"name": "arm", "count": 3, "share": 0.5, "on": true, "list": ["a", 1, "b"], "none": null})");
  return kExample;
}

TEST(JsonRead, GivesFieldsOfTheirType) {
  EXPECT_EQ(textIn(example(), "name"), "arm");
  EXPECT_EQ(numberIn<int>(example(), "count"), 3);
  EXPECT_EQ(numberIn<double>(example(), "share"), 0.5);
  EXPECT_EQ(fieldIn(example(), "on"), true);
  EXPECT_EQ(arrayIn(example(), "list").size(), 3U);
  EXPECT_EQ(textsIn(example(), "list"), (std::vector<std::string>{"a", "b"}));
}

TEST(JsonRead, TakesAMissingFieldOrAnotherTypeAsEmpty) {
  for (const char* key : {"missing", "none", "on"}) {
    SCOPED_TRACE(key);
    EXPECT_EQ(textIn(example(), key), "");
    EXPECT_EQ(textIn(example(), key, "otherwise"), "otherwise");
    EXPECT_EQ(numberIn<std::int64_t>(example(), key), 0);
    EXPECT_EQ(numberIn<int>(example(), key, 7), 7);
    EXPECT_TRUE(arrayIn(example(), key).empty());
    EXPECT_TRUE(textsIn(example(), key).empty());
  }
  EXPECT_TRUE(fieldIn(example(), "missing").is_null());
  EXPECT_EQ(textIn(example(), "count"), "");
  EXPECT_EQ(numberIn<int>(example(), "name"), 0);
}

TEST(JsonRead, TakesWhatIsNotAnObjectAsEmpty) {
  for (const char* text : {"null", "3", "\"name\"", "[\"name\"]"}) {
    SCOPED_TRACE(text);
    const OrderedTree tree = OrderedTree::parse(text);
    EXPECT_TRUE(fieldIn(tree, "name").is_null());
    EXPECT_EQ(textIn(tree, "name"), "");
    EXPECT_EQ(textIn(fieldIn(tree, "name"), "name"), "");
    EXPECT_TRUE(arrayIn(tree, "name").empty());
  }
}

TEST(JsonRead, FindsAnEnumeratorByItsName) {
  EXPECT_EQ(enumeratorNamed("small", Size::huge), Size::small);
  EXPECT_EQ(enumeratorNamed("huge", Size::huge), Size::huge);
  EXPECT_EQ(enumeratorNamed("huge", Size::large), std::nullopt);
  EXPECT_EQ(enumeratorNamed("", Size::huge), std::nullopt);
}

}  // namespace
}  // namespace rocinante
