#include "golden/run/value_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rocinante {
namespace {

/// The rotation from `from` to `to` as a vector, degrees.
void turnBetween(const double* from, const double* to, double* into) {
  // conjugate(from) * to
  const double x = from[3] * to[0] - from[0] * to[3] - from[1] * to[2] + from[2] * to[1];
  const double y = from[3] * to[1] + from[0] * to[2] - from[1] * to[3] - from[2] * to[0];
  const double z = from[3] * to[2] - from[0] * to[1] + from[1] * to[0] - from[2] * to[3];
  const double w = from[3] * to[3] + from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
  const double sine = std::sqrt(x * x + y * y + z * z);
  if (sine < 1e-15) {
    into[0] = into[1] = into[2] = 0;
    return;
  }
  const double sign = w < 0 ? -1 : 1;
  const double angle = 2 * std::atan2(sine, sign * w) * kDegrees;
  into[0] = sign * x / sine * angle;
  into[1] = sign * y / sine * angle;
  into[2] = sign * z / sine * angle;
}

}  // namespace

Apart apartOf(TrackColumn::Kind kind, const double* reference, const double* value) {
  Apart apart{};
  switch (kind) {
    case TrackColumn::Kind::angle:
      apart[0] = (value[0] - reference[0]) * kDegrees;
      break;
    case TrackColumn::Kind::full_angle:
      apart[0] = std::remainder(value[0] - reference[0], 2 * std::numbers::pi) * kDegrees;
      break;
    case TrackColumn::Kind::length:
      apart[0] = (value[0] - reference[0]) * kMillimetres;
      break;
    case TrackColumn::Kind::pose:
    case TrackColumn::Kind::link_pose:
      for (std::size_t i = 0; i < 3; ++i) apart[i] = (value[i] - reference[i]) * kMillimetres;
      turnBetween(reference + 3, value + 3, apart.data() + 3);
      break;
  }
  return apart;
}

void ApartRange::add(const Apart& apart) {
  if (!any) {
    least = most = apart;
    any = true;
    return;
  }
  for (std::size_t i = 0; i < apart.size(); ++i) {
    least[i] = std::min(least[i], apart[i]);
    most[i] = std::max(most[i], apart[i]);
  }
}

}  // namespace rocinante
