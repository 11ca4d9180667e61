#include "core/foreign/recordings/overwritten_rows.h"

#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kMaxFollowed = 65536;

}  // namespace

std::size_t OverwrittenRows::numberOf(std::string_view name) {
  if (const auto known = numbers_.find(name); known != numbers_.end()) return known->second;
  if (last_.size() >= kMaxFollowed) return kNoName;
  numbers_.emplace(name, last_.size());
  last_.emplace_back();
  return last_.size() - 1;
}

void OverwrittenRows::state(std::size_t name, Nanoseconds time, std::size_t line) {
  if (name == kNoName) return;
  const Stated before = std::exchange(last_[name], {time, line});
  if (before.line == 0 || before.line == line || before.time != time) return;
  if (counted_.size() >= kMaxFollowed) counted_.clear();
  if (!counted_.insert(before.line).second) return;
  if (count_++ == 0) first_line_ = before.line;
}

}  // namespace rocinante
