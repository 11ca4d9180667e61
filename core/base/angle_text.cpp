#include "core/base/angle_text.h"

#include <fmt/format.h>

#include <numbers>

namespace rocinante {

std::string angleText(double radians) {
  return fmt::format("{:.6g}°", radians * (180 / std::numbers::pi));
}

}  // namespace rocinante
