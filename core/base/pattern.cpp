#include "core/base/pattern.h"

#include <algorithm>
#include <cstddef>

namespace rocinante {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

/// One step of a pattern: how many bytes of it there are, and whether it describes a byte.
struct Step {
  std::size_t bytes = 0;
  bool matches = false;
};

/// Takes one member of a set, which may be escaped.
unsigned char memberAt(std::string_view pattern, std::size_t& at) {
  if (pattern[at] == '\\' && at + 1 < pattern.size()) ++at;
  return static_cast<unsigned char>(pattern[at++]);
}

/// `at` is behind a `[`. No bytes: there is no `]`.
Step matchSet(std::string_view pattern, std::size_t at, unsigned char byte) {
  const std::size_t opened = at;
  const bool is_inverted = at < pattern.size() && (pattern[at] == '!' || pattern[at] == '^');
  if (is_inverted) ++at;
  bool is_member = false;
  for (bool is_first = true; at < pattern.size(); is_first = false) {
    if (pattern[at] == ']' && !is_first) return {at + 1 - opened, is_member != is_inverted};
    const unsigned char low = memberAt(pattern, at);
    unsigned char high = low;
    if (at + 1 < pattern.size() && pattern[at] == '-' && pattern[at + 1] != ']') {
      ++at;
      high = memberAt(pattern, at);
    }
    is_member = is_member || (low <= byte && byte <= high);
  }
  return {};
}

/// The step at `at`, which is not a `*`, against one byte.
Step matchStep(std::string_view pattern, std::size_t at, char text) {
  const char first = pattern[at];
  if (first == '?') return {1, true};
  if (first == '\\') {
    return at + 1 < pattern.size() ? Step{2, pattern[at + 1] == text} : Step{1, false};
  }
  if (first == '[') {
    const Step set = matchSet(pattern, at + 1, static_cast<unsigned char>(text));
    if (set.bytes > 0) return {set.bytes + 1, set.matches};
  }
  return {1, first == text};
}

}  // namespace

bool patternMatches(std::string_view pattern, std::string_view text) {
  if (pattern == text) return true;
  std::size_t p = 0, t = 0;
  std::size_t star = kNone, star_end = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_end = t;
      continue;
    }
    if (p < pattern.size()) {
      if (const Step step = matchStep(pattern, p, text[t]); step.matches) {
        p += step.bytes;
        ++t;
        continue;
      }
    }
    if (star == kNone) return false;
    // The last star takes one byte more; earlier ones need no second try.
    p = star + 1;
    t = ++star_end;
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

bool anyPatternMatches(std::span<const std::string> patterns, std::string_view text) {
  return std::ranges::any_of(
      patterns, [&](const std::string& pattern) { return patternMatches(pattern, text); });
}

}  // namespace rocinante
