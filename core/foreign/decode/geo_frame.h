#pragma once

#include "core/foreign/decode/declaration.h"
#include "core/math/vector.h"

namespace rocinante::decode {

/// The frame of a place on the Earth: x east, y north, z up, in metres from it. Made from + - * /
/// sqrt and our own trigonometry: the same bits on every CPU. Pure.
class GeoFrame {
 public:
  explicit GeoFrame(const GeoPlace& origin);

  /// A place in Earth-centred, Earth-fixed metres (WGS 84) as seen from here.
  Vec3 positionOf(const Vec3& earth_m) const;
  /// The turn of a DIS entity, whose body has x forward, y right and z down: its angles turn about
  /// z, then the new y, then the new x, from the axes of the Earth. Gives that of a body with x
  /// forward, y left and z up, here; not numbers when an angle is none.
  Quat orientationOf(double psi_rad, double theta_rad, double phi_rad) const;

  /// The origin in Earth-centred, Earth-fixed metres.
  const Vec3& origin() const { return origin_m_; }

 private:
  Vec3 origin_m_;
  Vec3 east_, north_, up_;  ///< in the axes of the Earth
  Quat from_earth_;
};

}  // namespace rocinante::decode
