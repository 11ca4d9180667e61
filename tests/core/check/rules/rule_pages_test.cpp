// Checks every page of docs/rules: the program judges its examples.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/atomic_file.h"
#include "core/check/rules/rule_list.h"
#include "tests/core/check/rules/rule_example_run.h"

namespace rocinante {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "rules";

std::set<std::string> pagesOfFolder() {
  std::set<std::string> pages;
  for (const auto& each : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = each.path().stem().string();
    if (each.path().extension() == ".md" && name != "README") pages.insert(name);
  }
  return pages;
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

class RulePages : public ::testing::TestWithParam<std::string> {
 protected:
  static Result<test::RulePage> page() {
    const Result<test::RuleExample> defaults = test::readRuleDefaults(kFolder / "README.md");
    if (!defaults) return defaults.error();
    return test::readRulePage(kFolder / (GetParam() + ".md"), *defaults);
  }
};

TEST_P(RulePages, ShowWhatFiresTheRuleAndWhatDoesNot) {
  const Result<test::RulePage> read = page();
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->rule, GetParam());
  const Rule* const rule = findRule(GetParam());
  ASSERT_NE(rule, nullptr) << "no rule has this id";
  EXPECT_EQ(read->severity, nameOf(rule->severity));
  const std::string set = fmt::format("\"{}\" = \"", GetParam());
  EXPECT_NE(read->text.find(set), read->text.npos) << "it does not say how its severity is set";
  for (const char* section : {"\n## Mend\n", "\n## Severity\n", "\n## Fires\n"}) {
    EXPECT_NE(read->text.find(section), read->text.npos) << section;
  }
  if (!read->fires.cannot_show.empty()) return;
  EXPECT_NE(read->text.find("\n## Does not fire\n"), read->text.npos);

  std::set<std::string> expected(read->fires.also.begin(), read->fires.also.end());
  expected.insert(GetParam());
  EXPECT_EQ(rulesFiredBy(read->fires), expected) << "what the example under `Fires` fires";
  expected = std::set<std::string>(read->silent.also.begin(), read->silent.also.end());
  ASSERT_FALSE(expected.contains(GetParam()));
  EXPECT_EQ(rulesFiredBy(read->silent), expected) << "what that under `Does not fire` fires";
}

INSTANTIATE_TEST_SUITE_P(OfDocs, RulePages, ::testing::ValuesIn([] {
                           const std::set<std::string> pages = pagesOfFolder();
                           return std::vector<std::string>(pages.begin(), pages.end());
                         }()),
                         [](const auto& page) {
                           std::string name = page.param;
                           for (char& c : name) c = c == '.' || c == '-' ? '_' : c;
                           return name;
                         });

TEST(RulePageIndex, EveryRuleHasItsPageAndEveryPageItsRule) {
  const std::set<std::string> pages = pagesOfFolder();
  for (const Rule& rule : allRules()) {
    EXPECT_TRUE(pages.contains(std::string(rule.id)))
        << "docs/rules/" << rule.id << ".md is missing";
  }
  for (const std::string& page : pages) EXPECT_NE(findRule(page), nullptr) << page;
}

TEST(RulePageIndex, NamesEveryPage) {
  const Result<std::string> index = readFile(kFolder / "README.md");
  ASSERT_TRUE(index.ok()) << index.error().text();
  for (const std::string& page : pagesOfFolder()) {
    EXPECT_NE(index->find(fmt::format("[`{0}`]({0}.md)", page)), index->npos) << page;
  }
}

}  // namespace
}  // namespace rocinante
