#include <algorithm>
#include <optional>

#include "core/cell/posed_scene.h"
#include "core/math/trigonometry.h"
#include "core/math/turn_angle.h"
#include "golden/session/session_comparison.h"

namespace rocinante {
namespace {

/// How far two states are apart; the first difference decides.
struct MomentsApart {
  std::size_t facts = 0;  ///< that one has and the other has not, or otherwise
  double most = 0;        ///< of a link, in limits
  Nanoseconds away{0};
  auto operator<=>(const MomentsApart&) const = default;
};

std::size_t differing(const SessionState::Drawings& a, const SessionState::Drawings& b) {
  std::size_t count = 0;
  for (const auto& [key, value] : a) {
    const auto found = b.find(key);
    if (found == b.end() || !(found->second == value)) ++count;
  }
  for (const auto& [key, value] : b) count += a.contains(key) ? 0 : 1;
  return count;
}

/// In limits; 0 for what is rounding, so that the nearest in time of equal states is found.
double apartOf(const Mat4& a, const Mat4& b, const RunLimits& limits) {
  const double away_mm = glm::length(Vec3(a[3]) - Vec3(b[3])) * 1e3;
  const double turn_deg = degreesOf(turnAngle(a, b));
  const double apart = std::max(away_mm / limits.position_mm, turn_deg / limits.turn_deg);
  constexpr double kRounding = 1e-6;
  return apart < kRounding ? 0 : apart;
}

MomentsApart apartOf(const PosedScene& a, const SessionState& state_a, const PosedScene& b,
                     const SessionState& state_b, const RunLimits& limits) {
  MomentsApart apart;
  apart.facts = differing(state_a.drawings(), state_b.drawings());
  for (const PosedDevice& device : a.devices) {
    const PosedDevice* const other = b.findDevice(device.name);
    if (other == nullptr || other->model != device.model) {
      ++apart.facts;
      continue;
    }
    if (device.link_visible != other->link_visible) ++apart.facts;
    if (device.link_color != other->link_color) ++apart.facts;
    for (std::size_t link = 0; link < device.link_world.size(); ++link) {
      apart.most =
          std::max(apart.most, apartOf(device.link_world[link], other->link_world[link], limits));
    }
  }
  for (const PosedDevice& device : b.devices) {
    if (a.findDevice(device.name) == nullptr) ++apart.facts;
  }
  return apart;
}

}  // namespace

Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const RunLimits& limits) {
  const auto state_a = a.stateAt(in_a);
  if (!state_a.ok()) return state_a.error();
  const PosedScene scene_a = poseScene(cell, **state_a);
  LogTime best = in_b;
  std::optional<MomentsApart> least;
  for (const LogTime candidate : candidates) {
    const auto state_b = b.stateAt(candidate);
    if (!state_b.ok()) return state_b.error();
    MomentsApart apart = apartOf(scene_a, **state_a, poseScene(cell, **state_b), **state_b, limits);
    apart.away = std::chrono::abs(candidate - in_b);
    if (least && (apart <=> *least) >= 0) continue;
    least = apart;
    best = candidate;
  }
  return best;
}

}  // namespace rocinante
