#include "core/cell/cell_rules.h"

namespace rocinante {

bool readSeverity(std::string_view word, CellRule& rule) {
  if (word == "off") {
    rule.is_off = true;
    rule.severity.reset();
    return true;
  }
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
    if (word != nameOf(severity)) continue;
    rule.is_off = false;
    rule.severity = severity;
    return true;
  }
  return false;
}

}  // namespace rocinante
