#include "core/clearance/clearance_gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/cell/posed_scene.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

/// What decides which links there are, and what carries what.
std::string structureOf(const SessionState& state) {
  std::string text;
  const auto add = [&](std::string_view word) {
    text += word;
    text += '\0';
  };
  for (const auto& [name, device] : state.devices()) {
    add(name);
    if (device.presence) {
      add(device.presence->value.presence == Presence::added ? "+" : "-");
      add(device.presence->value.model);
    }
    if (!device.pose) continue;
    const Path& carrier = device.pose->value.carrier;
    add(carrier.is_layer ? "layer" : "in");
    add(carrier.first);
    add(carrier.second);
  }
  return text;
}

}  // namespace

double roundedClearance(double metres) {
  if (!(metres > 0)) return 0;
  return std::max(1.0, std::floor(metres * 1e5 + 0.5)) / 1e5;
}

ClearanceGauge::ClearanceGauge(const Cell& cell, Chosen chosen)
    : cell_(cell), chosen_(std::move(chosen)) {}

void ClearanceGauge::notice(const SessionState& state) {
  std::string structure = structureOf(state);
  if (is_arranged_ && structure == structure_) return;
  structure_ = std::move(structure);
  const PosedScene scene = poseScene(cell_, state);
  arrange(scene, placementOf(scene, state));
}

void ClearanceGauge::arrange(const PosedScene& scene, const CellPlacement& placement) {
  is_arranged_ = true;
  placement_ = placement;
  for (auto& [key, group] : groups_) group = {};
  ClearancePairs found = clearancePairs(cell_, scene, placement, bodies_);
  had_too_many_ = had_too_many_ || found.too_many;
  for (const ClearancePair& each : found.pairs) {
    const std::string& a = placement.devices[each.a.device].name;
    const std::string& b = placement.devices[each.b.device].name;
    if (chosen_ && !chosen_(a, b)) continue;
    static_cast<ClearancePair&>(groups_[{each.clearance, a, b}].pairs.emplace_back()) = each;
  }
}

CellPlacement ClearanceGauge::placed(const SessionState& state) {
  const PosedScene scene = poseScene(cell_, state);
  CellPlacement placement = placementOf(scene, state);
  if (!is_arranged_ || !sameStructure(placement, placement_)) arrange(scene, placement);
  return placement;
}

void ClearanceGauge::measure(const SessionState& state, std::vector<double>& distances_m) {
  const CellPlacement placement = placed(state);
  distances_m.clear();
  for (auto& [key, group] : groups_) distances_m.push_back(measure(group, placement));
}

std::vector<GapPlace> ClearanceGauge::places(const SessionState& state) {
  const CellPlacement placement = placed(state);
  std::vector<GapPlace> places;
  for (auto& [key, group] : groups_) {
    if (group.pairs.empty()) continue;
    GapPlace place{std::get<0>(key), measure(group, placement), {}, {}};
    // The nearest is always exact, so its points are those of now.
    const Pair& pair = group.pairs[group.nearest];
    const Mat4& world = placement.devices[pair.b.device].link_world[pair.b.link];
    place.on_a = transformPoint(world, pair.known.on_a);
    place.on_b = transformPoint(world, pair.known.on_b);
    places.push_back(place);
  }
  return places;
}

double ClearanceGauge::measure(Group& group, const CellPlacement& placement) {
  if (group.pairs.empty()) return std::numeric_limits<double>::quiet_NaN();
  constexpr double kAny = std::numeric_limits<double>::infinity();
  // The nearest the last time is mostly the nearest now, and then settles the others.
  const std::size_t first = group.nearest;
  double best = measure(group.pairs[first], placement, kAny);
  for (std::size_t i = 0; i < group.pairs.size() && best > 0; ++i) {
    if (i == first) continue;
    const double distance = measure(group.pairs[i], placement, best);
    if (!(distance < best)) continue;
    best = distance;
    group.nearest = i;
  }
  return best;
}

/// The distance of a pair if it is below `best_m`; else anything from there on.
double ClearanceGauge::measure(Pair& pair, const CellPlacement& placement, double best_m) {
  const auto worldOf = [&](LinkId id) -> const Mat4& {
    return placement.devices[id.device].link_world[id.link];
  };
  const Mat4 now = inverseOfRigid(worldOf(pair.b)) * worldOf(pair.a);
  const TriangleTree &a = *pair.body_a, &b = *pair.body_b;
  if (pair.is_measured) {
    const double moved = displacement(pair.measured_at, now, a.centre(), a.radius());
    const bool is_still = now == pair.measured_at;
    if (is_still && (pair.is_exact || !(pair.measured_m < best_m))) return pair.measured_m;
    if (!(pair.measured_m - moved < best_m)) return best_m;
  }
  const double of_spheres =
      lengthOf(transformPoint(now, a.centre()) - b.centre()) - a.radius() - b.radius();
  if (!(of_spheres < best_m)) return best_m;
  const BoundedDistance found = search_.bounded(a, b, now, {0, best_m}, &pair.known);
  pair.known = found.contact;
  pair.is_measured = true;
  pair.measured_at = now;
  pair.is_exact = found.contact.distance_m < best_m;
  pair.measured_m = pair.is_exact ? found.contact.distance_m : found.at_least_m;
  return found.contact.distance_m;
}

std::vector<ClearanceGap> ClearanceGauge::gaps() const {
  std::vector<ClearanceGap> gaps;
  for (const auto& [key, group] : groups_) {
    gaps.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key)});
  }
  return gaps;
}

std::vector<std::size_t> ClearanceGauge::unmeasured() const {
  std::vector<bool> has_one(cell_.clearances.size(), false);
  for (const auto& [key, group] : groups_) has_one[std::get<0>(key)] = true;
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < has_one.size(); ++i) {
    if (!has_one[i]) without.push_back(i);
  }
  return without;
}

}  // namespace rocinante
