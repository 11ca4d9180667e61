#include "core/packet/statement_device.h"

#include "core/base/pattern.h"

namespace rocinante {

bool isAboutDevice(const Statement& statement, std::span<const std::string> patterns) {
  const auto named = [&](std::string_view name) {
    return !name.empty() && anyPatternMatches(patterns, name);
  };
  switch (statement.kind) {
    case StatementKind::joints:
    case StatementKind::order:
    case StatementKind::joint:
    case StatementKind::pose:
    case StatementKind::add:
    case StatementKind::remove:
    case StatementKind::seen:
      return named(statement.name) || named(statement.carrier.first);
    case StatementKind::show:
    case StatementKind::hide:
    case StatementKind::color:
      return !statement.path.is_layer && named(statement.path.first);
    case StatementKind::line:
    case StatementKind::points:
    case StatementKind::label:
    case StatementKind::view:
      return named(statement.carrier.first);
    case StatementKind::erase:
    case StatementKind::event:
      return false;
  }
  return false;
}

}  // namespace rocinante
