#include "viewer/shown/value_text.h"

#include <fmt/format.h>

namespace rocinante {

std::string jointValueText(ValueKind kind, double value, const Units& units) {
  switch (kind) {
    case ValueKind::angle:
      return angleText(value, units.angle);
    case ValueKind::length:
      return lengthText(value, units.length);
    case ValueKind::turn:
      break;
  }
  return fmt::format("{:.4f}", value);
}

std::string positionText(const Vec3& position, LengthUnit unit) {
  return fmt::format("at {} {} {}", lengthNumber(position.x, unit), lengthNumber(position.y, unit),
                     lengthText(position.z, unit));
}

}  // namespace rocinante
