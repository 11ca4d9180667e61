#include "core/check/reports/worst_value.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/number_list.h"

namespace rocinante {
namespace {

/// What stands before the value, in the sentence of a rule.
struct Phrase {
  std::string_view rule, before;
  bool is_least = false;  ///< the smaller, the worse
};
constexpr auto kPhrases = std::to_array<Phrase>({
    {"clearance.too-close", " comes within ", true},
    {"joint.acceleration", " speeds up or slows down by "},
    {"joint.degrees", " are up to "},
    {"joint.jump", " jumps by "},
    {"joint.percent", " up to "},
    {"joint.velocity", " moves at "},
});

std::optional<double> numberAfter(std::string_view text, std::string_view before) {
  const std::size_t at = text.find(before);
  if (at == text.npos) return std::nullopt;
  std::string_view number = text.substr(at + before.size());
  number = number.substr(0, number.find_first_not_of("+-.0123456789e"));
  // A sentence may go on with a full stop.
  if (number.ends_with('.')) number.remove_suffix(1);
  const auto values = parseNumbers(number);
  if (!values.ok() || values->empty()) return std::nullopt;
  return values->front();
}

/// How far "[LOWER, UPPER]; the worst is VALUE" is beyond.
std::optional<double> excessOf(std::string_view text) {
  const auto lower = numberAfter(text, "outside its limits [");
  const std::size_t limits = text.find("outside its limits [");
  const auto upper = lower ? numberAfter(text.substr(limits), ", ") : std::nullopt;
  const auto worst = numberAfter(text, "the worst is ");
  if (!upper || !worst) return std::nullopt;
  return std::max(*lower - *worst, *worst - *upper);
}

}  // namespace

std::optional<double> worstValue(const Finding& finding) {
  if (finding.rule == "joint.limit") return excessOf(finding.text);
  for (const Phrase& phrase : kPhrases) {
    if (finding.rule != phrase.rule) continue;
    const auto value = numberAfter(finding.text, phrase.before);
    return value && phrase.is_least ? -*value : value;
  }
  return std::nullopt;
}

}  // namespace rocinante
