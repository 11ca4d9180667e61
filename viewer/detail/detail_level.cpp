#include "viewer/detail/detail_level.h"

#include <charconv>

namespace rocinante {

std::optional<int> parseDetailRung(std::string_view text) {
  int rung = -1;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), rung);
  if (fault != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  if (rung < 0 || rung > kCoarsestRung) return std::nullopt;
  return rung;
}

}  // namespace rocinante
