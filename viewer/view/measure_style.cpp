#include "viewer/view/measure_style.h"

#include <fmt/format.h>

#include "core/base/number_list.h"
#include "core/cell/view_path.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

std::optional<MeasurePoint> parsePoint(std::string_view text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string_view::npos) return std::nullopt;
  MeasurePoint point{std::string(text.substr(0, at)), {}};
  const auto path = parseViewPath(point.path);
  if (!path || path->all_devices || path->has_group || path->path.is_layer) return std::nullopt;
  const auto numbers = parseNumbers(text.substr(at + 1));
  if (!numbers || numbers->size() != 3) return std::nullopt;
  point.at = Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  return point;
}

std::string pointText(const MeasurePoint& point) {
  return fmt::format("{}@{},{},{}", point.path, point.at.x, point.at.y, point.at.z);
}

}  // namespace

std::optional<MeasureStyle> parseMeasure(std::string_view text) {
  const std::size_t between = text.find('~');
  if (between == std::string_view::npos || text.rfind('~') != between) return std::nullopt;
  auto from = parsePoint(text.substr(0, between));
  auto to = parsePoint(text.substr(between + 1));
  if (!from || !to) return std::nullopt;
  return MeasureStyle{std::move(*from), std::move(*to)};
}

std::string measureText(const MeasureStyle& measure) {
  return pointText(measure.from) + "~" + pointText(measure.to);
}

std::optional<Vec3> worldOf(const MeasurePoint& point, const PosedScene& scene) {
  const auto path = parseViewPath(point.path);
  if (!path) return std::nullopt;
  const auto space = scene.find(path->path.first, path->path.second);
  if (!space) return std::nullopt;
  return transformPoint(*space, point.at);
}

std::optional<double> distanceOf(const MeasureStyle& measure, const PosedScene& scene) {
  const auto from = worldOf(measure.from, scene);
  const auto to = worldOf(measure.to, scene);
  if (!from || !to) return std::nullopt;
  return lengthOf(*to - *from);
}

}  // namespace rocinante
