#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/cell/posed_scene.h"
#include "core/math/vector.h"

namespace rocinante {

/// A point fixed to a link: it moves with it.
struct MeasurePoint {
  std::string path;  ///< a PATH of a device (its base) or a link
  Vec3 at{};         ///< metres, in the space of that device or link
  bool operator==(const MeasurePoint&) const = default;
};

/// The distance between two points, drawn as a line with its length.
struct MeasureStyle {
  MeasurePoint from, to;
  bool operator==(const MeasureStyle&) const = default;
};

/// "PATH@X,Y,Z~PATH@X,Y,Z"; empty when it is not that.
std::optional<MeasureStyle> parseMeasure(std::string_view text);
/// The text for parseMeasure(), with the shortest numbers that read back as the same.
std::string measureText(const MeasureStyle& measure);

/// Where the point is in the world; empty when its device or link is not in the scene.
std::optional<Vec3> worldOf(const MeasurePoint& point, const PosedScene& scene);
/// Metres between both; empty when one is not there.
std::optional<double> distanceOf(const MeasureStyle& measure, const PosedScene& scene);

}  // namespace rocinante
