// Checks the pages of docs/rules: the program judges the examples of every rule.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/loaded_module.h"
#include "core/check/rules/rule_list.h"
#include "core/check/rules/rule_page.h"
#include "tests/core/check/rules/rule_example_run.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kFolder =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "rules";

Result<std::vector<test::RuleText>> readRules(const std::string& page) {
  const Result<test::RuleExample> defaults = test::readRuleDefaults(kFolder / "README.md");
  if (!defaults) return defaults.error();
  return test::readRulePage(kFolder / page, *defaults);
}

/// What a page has, by its name: "joint.md". Each is read once.
const Result<std::vector<test::RuleText>>& rulesOf(const std::string& page) {
  static std::map<std::string, Result<std::vector<test::RuleText>>> pages;
  auto found = pages.find(page);
  if (found == pages.end()) found = pages.emplace(page, readRules(page)).first;
  return found->second;
}

/// The page and the anchor that the program gives of the rule.
std::pair<std::string, std::string> placeOfRule(std::string_view rule) {
  const std::string place = placeOf(rule);
  const std::size_t mark = place.find('#');
  return {place.substr(0, mark), place.substr(mark + 1)};
}

std::set<std::string> rulesFiredBy(const test::RuleExample& example) {
  const Result<CheckReport> report = test::judgeExample(example);
  if (!report) {
    ADD_FAILURE() << report.error().text();
    return {};
  }
  std::set<std::string> rules;
  for (const Finding& finding : report->findings) rules.insert(finding.rule);
  return rules;
}

class RulePages : public ::testing::TestWithParam<std::string> {};

TEST_P(RulePages, ShowWhatFiresTheRuleAndWhatDoesNot) {
  const std::string of_page = placeOfRule(GetParam()).first;
  const Result<std::vector<test::RuleText>>& page = rulesOf(of_page);
  ASSERT_TRUE(page.ok()) << page.error().text();
  const auto text = std::ranges::find(*page, GetParam(), &test::RuleText::rule);
  ASSERT_NE(text, page->end()) << "its page has no heading of this id";
  const Rule& rule = *findRule(GetParam());
  EXPECT_EQ(text->severity, nameOf(rule.severity));
  EXPECT_THAT(text->text, HasSubstr("\n**Mend:** "));
  const std::string threshold = fmt::format("\"{}\" = {{ {} = ", rule.id, rule.threshold.key);
  if (rule.threshold.key.empty()) {
    EXPECT_THAT(text->text, Not(HasSubstr("**Threshold:**")));
  } else {
    EXPECT_THAT(text->text, HasSubstr("\n**Threshold:** "));
    EXPECT_THAT(text->text, HasSubstr(threshold));
  }
  if (!text->fires.cannot_show.empty()) return;
  EXPECT_THAT(text->text, HasSubstr("\n**Fires"));
  EXPECT_THAT(text->text, HasSubstr("\n**Does not fire:**"));
  if (of_page == "sdf.md" && !loadModule("librocinante_sdformat.so").ok()) {
    GTEST_SKIP() << "built without ROCINANTE_SDF (libsdformat)";
  }

  std::set<std::string> expected(text->fires.also.begin(), text->fires.also.end());
  expected.insert(GetParam());
  EXPECT_EQ(rulesFiredBy(text->fires), expected) << "what the example under `Fires` fires";
  EXPECT_EQ(rulesFiredBy(text->silent), std::set<std::string>())
      << "what that under `Does not fire` fires";
}

INSTANTIATE_TEST_SUITE_P(OfDocs, RulePages, ::testing::ValuesIn([] {
                           std::vector<std::string> rules;
                           for (const Rule& rule : allRules()) rules.emplace_back(rule.id);
                           return rules;
                         }()),
                         [](const auto& rule) {
                           std::string name = rule.param;
                           for (char& c : name) c = c == '.' || c == '-' ? '_' : c;
                           return name;
                         });

/// Every page but the index.
std::vector<std::string> pagesOfFolder() {
  std::vector<std::string> pages;
  for (const auto& each : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = each.path().filename().string();
    if (name.ends_with(".md") && name != "README.md") pages.push_back(name);
  }
  return pages;
}

TEST(RulePageIndex, EveryRuleIsOnOnePageAndThereOnce) {
  std::multiset<std::string> places, expected;
  for (const std::string& name : pagesOfFolder()) {
    const Result<std::vector<test::RuleText>>& page = rulesOf(name);
    ASSERT_TRUE(page.ok()) << page.error().text();
    EXPECT_TRUE(std::ranges::is_sorted(*page, {}, &test::RuleText::rule)) << name;
    for (const test::RuleText& text : *page) places.insert(name + " " + text.rule);
  }
  for (const Rule& rule : allRules()) {
    expected.insert(fmt::format("{} {}", placeOfRule(rule.id).first, rule.id));
  }
  EXPECT_EQ(places, expected);
}

/// The anchors of a page, as GitHub and scripts/check_pages make them: small letters, no points,
/// dashes for blanks.
std::multiset<std::string> anchorsOf(const std::string& page) {
  const Result<std::string> text = readFile(kFolder / page);
  std::multiset<std::string> anchors;
  if (!text) return anchors;
  std::istringstream lines(*text);
  bool in_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) in_block = !in_block;
    if (in_block || !line.starts_with('#')) continue;
    std::string anchor;
    for (const char c : line.substr(line.find(' ') + 1)) {
      const bool is_kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
      if (is_kept || c == ' ') {
        anchor += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      }
    }
    anchors.insert(anchor);
  }
  return anchors;
}

TEST(RulePageIndex, LinksOfTheProgramLeadToTheHeading) {
  for (const Rule& rule : allRules()) {
    const auto [page, anchor] = placeOfRule(rule.id);
    EXPECT_EQ(anchorsOf(page).count(anchor), 1U) << placeOf(rule.id);
    const Result<std::string> text = readFile(kFolder / page);
    ASSERT_TRUE(text.ok()) << text.error().text();
    const std::string_view name = rule.id.substr(rule.id.find('.') + 1);
    const std::string entry = fmt::format("[{}](#{})", name, anchor);
    EXPECT_THAT(text->substr(0, text->find("\n## ")), HasSubstr(entry)) << "the list of " << page;
  }
}

TEST(RulePageIndex, ListsEveryRuleAsItsPageHasIt) {
  const Result<std::string> index = readFile(kFolder / "README.md");
  ASSERT_TRUE(index.ok()) << index.error().text();
  for (const std::string& name : pagesOfFolder()) {
    const Result<std::vector<test::RuleText>>& page = rulesOf(name);
    ASSERT_TRUE(page.ok()) << page.error().text();
    for (const test::RuleText& text : *page) {
      EXPECT_THAT(*index, HasSubstr(fmt::format("\n| [`{}`]({}) | {} | {} |\n", text.rule,
                                                placeOf(text.rule), text.severity, text.summary)));
    }
  }
}

TEST(RulePageIndex, TheProgramHoldsWhatThePagesHave) {
  for (const Rule& rule : allRules()) {
    const RulePage* const held = findRulePage(rule.id);
    ASSERT_NE(held, nullptr) << rule.id;
    const std::string of_page = placeOfRule(rule.id).first;
    const Result<std::vector<test::RuleText>>& page = rulesOf(of_page);
    ASSERT_TRUE(page.ok()) << page.error().text();
    const auto text = std::ranges::find(*page, rule.id, &test::RuleText::rule);
    ASSERT_NE(text, page->end()) << rule.id;
    std::string expected = text->text.substr(1);  // it is a page of its own there
    if (expected.ends_with("\n\n")) expected.pop_back();
    EXPECT_EQ(held->markdown, expected);
    EXPECT_THAT(explanationOf(*held), HasSubstr(fmt::format("--rule {}=off", rule.id)));
  }
}

}  // namespace
}  // namespace rocinante
