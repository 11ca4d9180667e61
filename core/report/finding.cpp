#include "core/report/finding.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/report/account.h"

namespace rocinante {

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

std::string Finding::place() const {
  if (file.empty() || line == 0) return file;
  return column > 0 ? fmt::format("{}:{}:{}", file, line, column)
                    : fmt::format("{}:{}", file, line);
}

std::string Finding::print() const {
  return fmt::format("{}: {}: {}{} [{}]", place(), nameOf(severity), sentenceOf(*this),
                     hint.empty() ? "" : fmt::format(" ({})", hint), rule);
}

const Finding* firstError(const Findings& findings) {
  const auto found = std::ranges::find(findings, Severity::error, &Finding::severity);
  return found == findings.end() ? nullptr : &*found;
}

std::size_t countOf(const Findings& findings, Severity severity) {
  return static_cast<std::size_t>(std::ranges::count(findings, severity, &Finding::severity));
}

}  // namespace rocinante
