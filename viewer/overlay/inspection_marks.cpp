#include "viewer/overlay/inspection_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/plain_text.h"
#include "core/cell/view_path.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr double kAxisPx = 34;
constexpr double kAxisWidthPx = 2.5;
constexpr std::array<std::uint32_t, 3> kAxisColors{0xE8453BFF, 0x49B044FF, 0x3F86F0FF};
constexpr std::uint32_t kAxisShade = 0x14181C90;
constexpr std::uint32_t kMeasureInk = 0xFFD84AFF, kNameInk = 0xE8ECF0FF;
constexpr std::uint32_t kKeptInk = 0x52C765FF, kViolatedInk = 0xFF5A4DFF;

struct LinkSpace {
  Mat4 to_world{1.0};
  double depth = 0;
  std::string name;  ///< beside its axes; empty: none
};

void addAxes(Overlay& overlay, const LinkSpace& space, const Camera& camera) {
  const double length = kAxisPx * camera.metersPerPixel(space.depth) * overlay.scale();
  const Vec3 origin = positionOf(space.to_world);
  struct Axis {
    Vec3 end;
    double depth;
    std::uint32_t rgba;
  };
  std::vector<Axis> axes;
  for (int i = 0; i < 3; ++i) {
    const auto direction = normalized(Vec3(space.to_world[i]));
    if (!direction) continue;
    const Vec3 end = origin + *direction * length;
    axes.push_back({end, camera.depthOf(end), kAxisColors.at(static_cast<std::size_t>(i))});
  }
  // The farthest first, so that the nearest covers the others.
  std::ranges::stable_sort(axes, [](const Axis& a, const Axis& b) { return a.depth > b.depth; });
  for (const Axis& axis : axes) overlay.addLine({origin, axis.end}, kAxisShade, kAxisWidthPx + 2);
  for (const Axis& axis : axes) overlay.addLine({origin, axis.end}, axis.rgba, kAxisWidthPx);
}

/// A line with a dot at each end.
void addSpan(Overlay& overlay, const Vec3& from, const Vec3& to, std::uint32_t ink) {
  overlay.addLine({from, to}, kAxisShade, 4.5);
  overlay.addLine({from, to}, ink, 2);
  for (const Vec3& end : {from, to}) {
    overlay.addPoint(end, kAxisShade, 9);
    overlay.addPoint(end, ink, 6);
  }
}

}  // namespace

void addLinkFrames(Overlay& overlay, const PosedScene& scene, const ViewChoice& choice,
                   const std::vector<std::string>& frames, const Camera& camera,
                   const TextAtlas& atlas) {
  std::vector<ViewPath> paths;
  for (const std::string& frame : frames) {
    if (auto path = parseViewPath(frame)) paths.push_back(std::move(*path));
  }
  if (paths.empty()) return;
  std::vector<LinkSpace> spaces;
  for (const PosedDevice& device : scene.devices) {
    for (std::size_t link = 0; link < device.link_world.size(); ++link) {
      const bool named = std::ranges::any_of(
          paths, [&](const ViewPath& path) { return path.namesLink(device, link); });
      if (!named || !device.placed || !choice.linkVisible(device, link)) continue;
      const double depth = camera.depthOf(positionOf(device.link_world[link]));
      // NaN has no order, and what is behind the camera no picture.
      if (!std::isfinite(depth) || (depth <= 0 && !camera.orthographic())) continue;
      spaces.push_back({device.link_world[link], depth, device.bare ? device.name : ""});
    }
  }
  std::ranges::stable_sort(
      spaces, [](const LinkSpace& a, const LinkSpace& b) { return a.depth > b.depth; });
  for (const LinkSpace& space : spaces) addAxes(overlay, space, camera);
  for (const LinkSpace& space : spaces) {
    if (space.name.empty()) continue;
    overlay.addLabel(atlas, positionOf(space.to_world), kNameInk, plainText(space.name));
  }
}

void addCameraCone(Overlay& overlay, const Camera& shown, double depth_m, const Camera& camera) {
  constexpr std::uint32_t kConeInk = 0xFFA840FF, kConeShade = 0x14181CB0;
  if (!camera.orthographic() || !(depth_m > 0) || !std::isfinite(depth_m)) return;
  const auto corners = [&](double depth) {
    const double unit = shown.orthographic() || depth > 0 ? shown.metersPerPixel(depth) : 0;
    const Vec3 across = shown.right() * (unit * shown.width() / 2 * shown.pixelAspect());
    const Vec3 upward = shown.up() * (unit * shown.height() / 2);
    const Vec3 middle = shown.eye() + shown.forward() * depth - across * shown.center().x -
                        upward * shown.center().y;
    return std::array{middle - across - upward, middle + across - upward, middle + across + upward,
                      middle - across + upward};
  };
  const auto pixel = [&](const Vec3& world) {
    const Vec4 clip = camera.clipOf(world);
    return Vec2((clip.x + 1) / 2 * overlay.width(), (1 - clip.y) / 2 * overlay.height());
  };
  const auto from = corners(0), to = corners(depth_m);
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (std::size_t i = 0; i < from.size(); ++i) {
    lines.emplace_back(pixel(from.at(i)), pixel(to.at(i)));
    lines.emplace_back(pixel(to.at(i)), pixel(to.at((i + 1) % to.size())));
  }
  for (const auto& [a, b] : lines) overlay.addScreenLine(a, b, kConeShade, 3.5);
  for (const auto& [a, b] : lines) overlay.addScreenLine(a, b, kConeInk, 1.5);
  overlay.addPoint(shown.eye(), kConeShade, 11);
  overlay.addPoint(shown.eye(), kConeInk, 8);
}

void addClearances(Overlay& overlay, const std::vector<ClearanceLine>& lines, LengthUnit unit,
                   const TextAtlas& atlas) {
  // Those that are kept first, so that a violation covers them.
  for (const bool is_kept : {true, false}) {
    for (const ClearanceLine& line : lines) {
      if (line.is_kept != is_kept) continue;
      addSpan(overlay, line.from, line.to, is_kept ? kKeptInk : kViolatedInk);
      overlay.addLabel(atlas, (line.from + line.to) * 0.5, is_kept ? kKeptInk : kViolatedInk,
                       lengthText(line.distance_m, unit));
    }
  }
}

void addMeasures(Overlay& overlay, const PosedScene& scene, const RenderStyle& style,
                 const TextAtlas& atlas) {
  for (const MeasureStyle& measure : style.measures) {
    const auto from = worldOf(measure.from, scene);
    const auto to = worldOf(measure.to, scene);
    if (!from || !to) continue;
    const double length = lengthOf(*to - *from);
    if (!std::isfinite(length)) continue;
    addSpan(overlay, *from, *to, kMeasureInk);
    // Picking has begun, and there is no second point yet.
    if (measure.from == measure.to) continue;
    overlay.addLabel(atlas, (*from + *to) * 0.5, kMeasureInk, lengthText(length, style.lengths));
  }
}

}  // namespace rocinante
