#pragma once

#include <array>
#include <numbers>

#include "golden/run/session_track.h"

namespace rocinante {

inline constexpr double kDegrees = 180 / std::numbers::pi;  ///< in a radian
inline constexpr double kMillimetres = 1000;                ///< in a metre

/// Components in which a value may differ from another of its column: degrees, or millimetres and
/// then degrees.
using Apart = std::array<double, 6>;

/// What leads from `reference` to `value`, two values of a column of this kind.
Apart apartOf(TrackColumn::Kind kind, const double* reference, const double* value);

/// The least and the most of several, each component by itself.
struct ApartRange {
  Apart least{}, most{};
  bool any = false;

  void add(const Apart& apart);
};

}  // namespace rocinante
