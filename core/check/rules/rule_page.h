#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rocinante {

/// docs/rules/ID.md, embedded in the library so that a program can explain its rules anywhere.
struct RulePage {
  std::string_view rule;
  std::string_view markdown;
};

/// Null when there is no page of that rule.
const RulePage* findRulePage(std::string_view rule);

/// The explanation of the rule: the page between its first paragraph and "Mend". Markdown.
std::string_view meaningOf(const RulePage& page);
/// The paragraphs below "## `section`"; empty when there is none.
std::string_view sectionOf(const RulePage& page, std::string_view section);

namespace detail {
// Made from docs/rules when the library is built, sorted by rule.
extern const RulePage kRulePages[];
extern const std::size_t kRulePageCount;
}  // namespace detail

}  // namespace rocinante
