#include "core/check/rules/rule_page.h"

#include <algorithm>
#include <span>

namespace rocinante {
namespace {

constexpr std::string_view kMend = "\n**Mend:** ";

std::string_view trimmed(std::string_view text) {
  while (text.starts_with('\n')) text.remove_prefix(1);
  while (text.ends_with('\n')) text.remove_suffix(1);
  return text;
}

}  // namespace

const RulePage* findRulePage(std::string_view rule) {
  const std::span<const RulePage> pages(detail::kRulePages, detail::kRulePageCount);
  const auto found = std::find_if(pages.begin(), pages.end(),
                                  [&](const RulePage& page) { return page.rule == rule; });
  return found != pages.end() ? &*found : nullptr;
}

std::string placeOf(std::string_view rule) {
  // The heading is the id, and GitHub leaves dots out of anchors.
  std::string anchor(rule);
  std::erase(anchor, '.');
  return std::string(rule.substr(0, rule.find('.'))) + ".md#" + anchor;
}

std::string_view meaningOf(const RulePage& page) {
  // After the heading and the paragraph that begins with the severity.
  const std::string_view text = page.markdown;
  const std::size_t severity = text.find("\n**");
  const std::size_t from = text.find("\n\n", severity == text.npos ? 0 : severity);
  const std::size_t until = text.find(kMend);
  if (from == text.npos || until == text.npos || until < from) return {};
  return trimmed(text.substr(from, until - from));
}

std::string_view mendOf(const RulePage& page) {
  const std::size_t at = page.markdown.find(kMend);
  if (at == page.markdown.npos) return {};
  const std::string_view below = page.markdown.substr(at + kMend.size());
  return trimmed(below.substr(0, below.find("\n\n**")));
}

std::string explanationOf(const RulePage& page) {
  std::string text(page.markdown);
  const std::string rule(page.rule);
  text += "\n**Severity:** in the cell, `\"" + rule +
          "\" = \"off\"` below `[rules]`; for one run,\n`--rule " + rule +
          "=off`. `note`, `warning` and `error` set another.\n";
  text += "\nPage: docs/rules/" + placeOf(rule) + ", with the files that examples share.\n";
  return text;
}

}  // namespace rocinante
