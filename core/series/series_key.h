#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/math/vector.h"

namespace rocinante {

/// One value of a session as a function of time. As text it is what a table's column is named
/// (docs/programs/source.md): DEVICE.JOINT, or DEVICE:x :y :z :qx :qy :qz :qw of the pose that
/// packets state; DEVICE/LINK:x and so on of a link in the world, or `DEVICE/LINK:x in PATH` in the
/// frame of a device or link; `signal PATH NAME` with names as packets write them; and rate/SOURCE,
/// loss/SOURCE for the packets of a source, rate and loss for all; and what is derived of values
/// (derived_value.h).
struct SeriesKey {
  enum class Kind : std::uint8_t { joint, pose, rate, loss, signal, link, derived };
  Kind kind = Kind::joint;
  /// Of the device or source; empty: all sources, or a signal's no device; of a derived one its
  /// text.
  std::string name{};
  std::string part{};        ///< the joint's value, or "x" and so on, or the NAME of a signal
  std::string link{};        ///< of a link, never empty; of a signal, empty: of the device itself
  std::string frame{};       ///< of a link: the device in whose frame it is; empty: the world
  std::string frame_link{};  ///< the link of that; empty: the device itself
  auto operator<=>(const SeriesKey&) const = default;

  bool isOfDevice() const {
    return kind == Kind::joint || kind == Kind::pose || kind == Kind::link;
  }
  /// True for what packets state, or move, and what is derived of it: false for counts of packets.
  bool isValue() const { return isOfDevice() || kind == Kind::signal || kind == Kind::derived; }
  /// As above; names of devices, joints and sources as they are.
  std::string text() const;
};

/// The parts of a pose: metres, then the unit quaternion.
inline constexpr std::array<std::string_view, 7> kPoseParts{"x", "y", "z", "qx", "qy", "qz", "qw"};

/// "x" is 0 and "qw" 6; empty for anything else.
std::optional<std::size_t> posePart(std::string_view part);

/// x y z qx qy qz qw.
std::array<double, 7> poseNumbers(const Pose& pose);

/// Reads text(). The first point, the first slash and the last colon separate. Empty when it is
/// none of these.
std::optional<SeriesKey> parseSeriesKey(std::string_view text);
/// The sentence for a text that it does not read.
std::string notPlotted(std::string_view text);
/// As parseSeriesKey(), but for derived ones.
std::optional<SeriesKey> parseStatedKey(std::string_view text);

/// The two texts of `VALUE over VALUE`, as they were written, where both are values; empty for
/// anything else.
std::optional<std::pair<std::string, std::string>> parsePath(std::string_view text);

}  // namespace rocinante
