#include "core/model/model_fault.h"

#include <fmt/format.h>

#include "core/model/fault_list.h"

namespace rocinante {
namespace {

constexpr std::size_t kListedPerRule = 100;

}  // namespace

std::string_view nameOf(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

std::string ModelFault::print() const {
  std::string printed = file;
  if (line > 0) printed += fmt::format(":{}", line);
  if (line > 0 && column > 0) printed += fmt::format(":{}", column);
  printed += fmt::format(": {}: {}", nameOf(severity), text);
  if (!hint.empty()) printed += fmt::format(" ({})", hint);
  return printed + fmt::format(" [{}]", rule);
}

void FaultList::add(Severity severity, std::string_view rule, Place place, std::string text,
                    std::string hint) {
  auto found = counts_.find(rule);
  if (found == counts_.end()) found = counts_.emplace(std::string(rule), Count{}).first;
  found->second.severity = severity;
  if (++found->second.times > kListedPerRule) return;
  faults_.push_back({severity, std::string(rule), file_, place.line, place.column, std::move(text),
                     std::move(hint)});
}

bool FaultList::lists(std::string_view rule) const {
  const auto found = counts_.find(rule);
  return found == counts_.end() || found->second.times < kListedPerRule;
}

FaultList::~FaultList() {
  for (const auto& [rule, count] : counts_) {
    if (count.times <= kListedPerRule) continue;
    faults_.push_back({count.severity, rule, file_, 0, 0,
                       fmt::format("{} more of these", count.times - kListedPerRule), ""});
  }
}

}  // namespace rocinante
