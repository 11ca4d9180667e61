#include "core/document/fault_list.h"

#include <fmt/format.h>

namespace rocinante {
namespace {

constexpr std::size_t kListedPerRule = 100;
constexpr std::size_t kQuotedBytes = 60;
constexpr std::size_t kLongestFileName = 256;  // with a slash; Linux has none longer

std::string escapedInFault(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      escaped += fmt::format("\\x{:02x}", byte);
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace

void FaultList::add(Severity severity, std::string_view rule, Place place, std::string text,
                    std::string hint) {
  auto found = counts_.find(rule);
  if (found == counts_.end()) found = counts_.emplace(std::string(rule), Count{}).first;
  found->second.severity = severity;
  if (++found->second.times > kListedPerRule) return;
  faults_.push_back({.rule = std::string(rule),
                     .severity = severity,
                     .text = std::move(text),
                     .hint = std::move(hint),
                     .file = file_,
                     .line = place.line,
                     .column = place.column});
}

void FaultList::leaveOut(std::string_view kind, std::string_view name, Place place,
                         std::string reason, Severity severity, std::string_view rule,
                         std::string hint, std::uint64_t count) {
  const std::string what =
      name.empty() ? std::string(kind) : fmt::format("{} {}", kind, quotedInFault(name));
  if (const auto known = left_out_.find(what); known != left_out_.end()) {
    if (known->second < faults_.size()) faults_[known->second].count += count;
    return;
  }
  const bool is_listed = lists(rule);
  add(severity, rule, place, std::move(reason), std::move(hint));
  if (!is_listed) return;
  faults_.back().left_out = what;
  faults_.back().count = count;
  left_out_.emplace(what, faults_.size() - 1);
}

bool FaultList::lists(std::string_view rule) const {
  const auto found = counts_.find(rule);
  return found == counts_.end() || found->second.times < kListedPerRule;
}

FaultList::~FaultList() {
  for (const auto& [rule, count] : counts_) {
    if (count.times <= kListedPerRule) continue;
    faults_.push_back({.rule = rule,
                       .severity = count.severity,
                       .text = fmt::format("{} more of these", count.times - kListedPerRule),
                       .file = file_});
  }
}

std::string quotedInFault(std::string_view text) {
  std::string quoted = "`" + escapedInFault(text.substr(0, kQuotedBytes));
  if (text.size() > kQuotedBytes) quoted += "...";
  return quoted + "`";
}

std::string quotedPathInFault(std::string_view path) {
  if (path.size() <= kQuotedBytes) return quotedInFault(path);
  // Cut at a slash where possible, not in the middle of a folder's name.
  std::string_view end = path.substr(path.size() - kQuotedBytes);
  const std::size_t slash = end.find_first_of("/\\");
  if (slash != std::string_view::npos) {
    end.remove_prefix(slash);
  } else {
    const std::size_t file = path.find_last_of("/\\");
    if (file != std::string_view::npos) end = path.substr(file);
    end = end.substr(0, kLongestFileName);
  }
  return "`..." + escapedInFault(end) + "`";
}

}  // namespace rocinante
