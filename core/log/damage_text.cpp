#include "core/log/damage_text.h"

#include <fmt/format.h>

namespace rocinante {

std::string damageText(std::string_view cause, std::string_view file, std::uint64_t byte) {
  return fmt::format("{} ({}, byte {})", cause, file, byte);
}

}  // namespace rocinante
