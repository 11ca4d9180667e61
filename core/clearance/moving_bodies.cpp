#include "core/clearance/moving_bodies.h"

#include <algorithm>

#include "core/clearance/tree_distance.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

/// More than the rounding of a placement: sums of it stay bounds from above.
constexpr double kStepRounding_m = 1e-12;

/// Of a link that moves by `travel` in the world. D bounds how far a point of it is from a joint:
/// the chain of origins keeps its length but for what slides. Its acceleration is at most w^2 D + 2
/// w v and its speed w D + v; no point is farther from the straight way than an eighth of the one,
/// or half of the other.
double bulgeOf(const LinkTravel& travel, const TriangleTree& body) {
  const double turn = travel.turn_rad, slide = travel.slide_m;
  const double reach = travel.reach_m + slide + lengthOf(body.centre()) + body.radius();
  return std::min((turn * turn * reach + 2 * turn * slide) / 8, (turn * reach + slide) / 2);
}

}  // namespace

void MovingBodies::clear() {
  bodies_.clear();
  by_link_.clear();
}

std::size_t MovingBodies::add(LinkId link, const TriangleTree& body,
                              const CellPlacement& placement) {
  const auto [found, is_new] = by_link_.try_emplace(link, bodies_.size());
  if (is_new) {
    const Mat4& world = placement.devices[link.device].link_world[link.link];
    bodies_.push_back({link, &body, 0, 0, 0, transformPoint(world, body.centre())});
  }
  return found->second;
}

void MovingBodies::step(const CellPlacement& from, const CellPlacement& to,
                        const CellTravel& travel) {
  for (MovingBody& moving : bodies_) {
    const LinkTravel& of_link = travel[moving.link.device][moving.link.link];
    moving.step_m = moving.bulge_m = 0;
    if (of_link.turn_rad <= 0 && of_link.slide_m <= 0) continue;
    const TriangleTree& body = *moving.body;
    const Mat4& start = from.devices[moving.link.device].link_world[moving.link.link];
    const Mat4& end = to.devices[moving.link.device].link_world[moving.link.link];
    moving.step_m = displacement(start, end, body.centre(), body.radius()) + kStepRounding_m;
    moving.moved_m += moving.step_m;
    moving.bulge_m = bulgeOf(of_link, body);
    moving.centre_world = transformPoint(end, body.centre());
  }
}

}  // namespace rocinante
