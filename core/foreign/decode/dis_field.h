#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocinante::decode {

/// A field of a DIS Entity State PDU (IEEE 1278.1) by the name that a declaration gives it with
/// `at`: docs/decoders.md, "DIS".
struct DisField {
  enum class Quantity : std::uint8_t {
    version,
    exercise,
    site,
    application,
    entity,
    force,
    kind,
    domain,
    country,
    category,
    subcategory,
    specific,
    extra,
    appearance,
    marking,
    velocity_x,
    velocity_y,
    velocity_z,
    location_x,
    location_y,
    location_z,
    psi,
    theta,
    phi,
    // In the frame of Decoder::origin: metres; the unit quaternion of the body's turn.
    local_x,
    local_y,
    local_z,
    local_qx,
    local_qy,
    local_qz,
    local_qw,
    articulation
  };
  Quantity quantity = Quantity::version;
  /// Of an articulation: its part's class plus its metric.
  std::uint32_t parameter_type = 0;

  bool isLocal() const { return quantity >= Quantity::local_x && quantity <= Quantity::local_qw; }
};

/// The field of a name: "marking", "location.x", "primary-turret-1.azimuth", "4096.azimuth"; empty
/// for another name.
std::optional<DisField> disFieldNamed(std::string_view name);
/// The name of an articulation: "PART.METRIC", in numbers where they have no name.
std::string articulationName(std::uint32_t parameter_type);

}  // namespace rocinante::decode
