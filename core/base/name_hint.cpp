#include "core/base/name_hint.h"

#include <algorithm>

namespace rocinante {
namespace {

// Longer names and longer lists are not worth a hint's time.
constexpr std::size_t kLongestName = 64;
constexpr std::size_t kMaxNames = 5000;
constexpr std::size_t kMaxListed = 12;

char folded(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return c == '-' ? '_' : c;
}

// Edits between two names: insertions, deletions, changes and swaps of neighbours.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = folded(a[i - 1]) == folded(b[j - 1]);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, previous);
    std::swap(previous, row);
  }
  return previous[b.size()];
}

}  // namespace

std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known) {
  if (name.empty() || name.size() > kLongestName || known.size() > kMaxNames) return {};
  const std::size_t allowed = name.size() <= 3 ? 1 : name.size() <= 7 ? 2 : 3;
  std::size_t best = allowed + 1;
  std::string_view closest;
  for (const std::string_view candidate : known) {
    if (candidate.empty() || candidate.size() > kLongestName) continue;
    const std::size_t distance = editDistance(name, candidate);
    if (distance >= best || distance >= std::max(name.size(), candidate.size())) continue;
    best = distance;
    closest = candidate;
  }
  if (closest.empty()) return {};
  return "did you mean `" + std::string(closest) + "`?";
}

std::string whatThereIs(std::string_view name, const std::vector<std::string_view>& known) {
  std::string hint = didYouMean(name, known);
  if (!hint.empty()) return hint;
  if (known.empty()) return "there are none";
  if (known.size() == 1) return "there is only " + std::string(known.front());
  hint = "there are ";
  for (std::size_t i = 0; i < std::min(known.size(), kMaxListed); ++i) {
    hint += (i > 0 ? ", " : "") + std::string(known[i]);
  }
  if (known.size() > kMaxListed) hint += " ... (" + std::to_string(known.size()) + " in all)";
  return hint;
}

}  // namespace rocinante
