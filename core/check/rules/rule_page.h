#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rocinante {

/// What the page of a family says of one rule, embedded in the library so that a program can
/// explain its rules anywhere.
struct RulePage {
  std::string_view rule;
  std::string_view markdown;
};

/// Null when no page has that rule.
const RulePage* findRulePage(std::string_view rule);

/// Where docs/rules has the rule, as a link from there: "joint.md#jointlimit".
std::string placeOf(std::string_view rule);

/// The explanation of the rule: what is between its first paragraph and "Mend". Markdown.
std::string_view meaningOf(const RulePage& page);
std::string_view mendOf(const RulePage& page);
/// All that the page says of it, and how its severity is set. Markdown.
std::string explanationOf(const RulePage& page);

namespace detail {
// Made from docs/rules when the library is built, sorted by rule.
extern const RulePage kRulePages[];
extern const std::size_t kRulePageCount;
}  // namespace detail

}  // namespace rocinante
