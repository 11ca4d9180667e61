#include "viewer/shown/state_shape.h"

#include <bit>

namespace rocinante {

StateShape stateShape(const std::vector<StateColumn>& columns) {
  StateShape shape;
  std::optional<std::uint8_t> held;  // as the column begins
  const auto extend = [&shape](std::size_t column, std::uint8_t state) {
    const auto left = static_cast<float>(column);
    if (!shape.bands.empty() && shape.bands.back().until == left &&
        shape.bands.back().state == state) {
      shape.bands.back().until = left + 1;
    } else {
      shape.bands.push_back({left, left + 1, state});
    }
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const StateBin& bin = columns[i].bin;
    if (std::popcount(bin.seen) > 1) {
      shape.mixed.push_back({static_cast<float>(i), bin.seen});
    } else if (bin.hasSample()) {
      extend(i, bin.last);
    } else if (held && columns[i].held) {
      extend(i, *held);
    } else if (columns[i].held) {
      extend(i, *columns[i].held);
    }
    held = columns[i].held;
  }
  return shape;
}

std::size_t colorOfState(std::string_view text, std::size_t count) {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return (hash ^ hash >> 16U) % count;
}

}  // namespace rocinante
