#include "core/document/model_fault.h"

#include <fmt/format.h>

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

std::string ModelFault::print() const {
  std::string printed = file;
  if (line > 0) printed += fmt::format(":{}", line);
  if (line > 0 && column > 0) printed += fmt::format(":{}", column);
  printed += fmt::format(": {}: {}", nameOf(severity), text);
  if (!hint.empty()) printed += fmt::format(" ({})", hint);
  return printed + fmt::format(" [{}]", rule);
}

}  // namespace rocinante
