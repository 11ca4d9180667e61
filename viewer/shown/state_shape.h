#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/series/value_bins.h"

namespace rocinante {

/// The states of a value as bands, in columns from the left end.
struct StateShape {
  /// From the beginning of a column until that of another; neighbours differ.
  struct Band {
    float from = 0, until = 0;
    std::uint8_t state = 0;
    bool operator==(const Band&) const = default;
  };
  /// A column in which it had several states, and is whole only as these.
  struct Mixed {
    float x = 0;
    std::uint64_t seen = 0;  ///< a bit for each
    bool operator==(const Mixed&) const = default;
  };
  std::vector<Band> bands;
  std::vector<Mixed> mixed;
};

/// A state holds until the next one. Pure.
StateShape stateShape(const std::vector<StateColumn>& columns);

/// A number for the colour of a state, the same for the same text everywhere; below `count`.
std::size_t colorOfState(std::string_view text, std::size_t count);

}  // namespace rocinante
