#include "core/clearance/clearance_judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr double kJumpTurn_rad = kPi, kJumpSlide_m = 2;
/// A turn for which the bulge's bound is of use; longer ones are halved at once.
constexpr double kSweptTurn_rad = 0.5;
/// 2 m / 2^17 is below the tolerance: no part of a step needs more halvings.
constexpr std::uint32_t kMaxDepth = 17;
/// Of parts whose middle is kept for the other pairs of the step.
constexpr std::uint32_t kSharedDepth = 6;

/// How much the links of a pair move against each other in a step, at most.
LinkTravel relativeTravel(const CellTravel& travel, const ClearancePair& pair) {
  const LinkTravel& a = travel[pair.a.device][pair.a.link];
  const LinkTravel& b = travel[pair.b.device][pair.b.link];
  LinkTravel sum{a.turn_rad + b.turn_rad, a.slide_m + b.slide_m, a.reach_m + b.reach_m};
  if (pair.common) {
    const LinkTravel& shared = travel[pair.common->device][pair.common->link];
    sum.turn_rad = std::max(0.0, sum.turn_rad - 2 * shared.turn_rad);
    sum.slide_m = std::max(0.0, sum.slide_m - 2 * shared.slide_m);
    sum.reach_m = std::max(0.0, sum.reach_m - 2 * shared.reach_m);
  }
  sum.reach_m += sum.slide_m;  // at most, once it has slid
  return sum;
}

/// How far the points of a's body, moving by `travel` in b's space, leave straight lines: their
/// acceleration is at most w^2 D + 2 w v, where D is the largest distance of a point from a joint.
/// Infinite where the step is too long for that to be of use.
double bulgeOf(const LinkTravel& travel, const TriangleTree& body, const Mat4& a_in_b) {
  const double turn = travel.turn_rad, slide = travel.slide_m;
  if (!(turn < kSweptTurn_rad)) return std::numeric_limits<double>::infinity();
  const double reach =
      travel.reach_m + lengthOf(body.centre()) + body.radius() + lengthOf(positionOf(a_in_b));
  // It may grow by as much as the motion is long.
  const double swept_reach = reach + (slide + turn * reach) / (1 - turn);
  return (turn * turn * swept_reach + 2 * turn * slide) / 8;
}

const Mat4& worldOfB(const ClearancePair& pair, const CellPlacement& placement) {
  return placement.devices[pair.b.device].link_world[pair.b.link];
}

/// The same pair in another placement: its clearance, its devices' names, and its bodies.
using PairKey = std::tuple<std::size_t, std::string, std::string, const TriangleTree*,
                           const TriangleTree*, std::size_t, std::size_t>;
PairKey keyOf(const ClearancePair& pair, const CellPlacement& placement) {
  return {pair.clearance,
          placement.devices[pair.a.device].name,
          placement.devices[pair.b.device].name,
          pair.body_a,
          pair.body_b,
          pair.a.link,
          pair.b.link};
}

std::string nameOfLink(const CellPlacement& placement, LinkId id) {
  const PlacedDevice& device = placement.devices[id.device];
  return device.name + "/" + device.model->links[id.link].name;
}

}  // namespace

/// A step from one placement to the next. The placements in the middle of its larger parts are made
/// once, for all pairs.
struct ClearanceJudge::Step {
  const CellPlacement& from;
  const CellPlacement& to;
  LogTime began, ended;
  CellTravel travel;
  std::map<std::pair<std::uint32_t, std::uint64_t>, CellPlacement> middles{};

  LogTime timeOf(Part part) const {
    const double share =
        static_cast<double>(part.number) / static_cast<double>(std::uint64_t{1} << part.depth);
    const double whole_ns = static_cast<double>((ended - began).count());
    return began + Nanoseconds(static_cast<std::int64_t>(whole_ns * share));
  }
};

std::size_t ClearanceJudge::outcomeOf(const ClearancePair& pair) {
  const std::string& a = placement_.devices[pair.a.device].name;
  const std::string& b = placement_.devices[pair.b.device].name;
  const auto [found, is_new] =
      outcome_by_names_.try_emplace({pair.clearance, a, b}, outcomes_.size());
  if (is_new) {
    ClearanceOutcome& outcome = outcomes_.emplace_back();
    outcome.clearance = pair.clearance;
    outcome.device_a = a;
    outcome.device_b = b;
    outcome.min_m = cell_.clearances[pair.clearance].min_m;
  }
  return found->second;
}

Mat4 ClearanceJudge::relative(const CellPlacement& placement, const Pair& pair) const {
  return inverseOfRigid(placement.devices[pair.b.device].link_world[pair.b.link]) *
         placement.devices[pair.a.device].link_world[pair.a.link];
}

void ClearanceJudge::begin(LogTime time, const PosedScene& scene, CellPlacement placement) {
  has_begun_ = true;
  time_ = time;
  const CellPlacement old = std::exchange(placement_, std::move(placement));
  ClearancePairs found = clearancePairs(cell_, scene, placement_, bodies_);
  had_too_many_ = had_too_many_ || found.too_many;
  was_judged_.resize(cell_.clearances.size(), false);
  const std::vector<Pair> before = std::exchange(pairs_, {});
  std::map<PairKey, const Pair*> known;
  for (const Pair& pair : before) known.emplace(keyOf(pair, old), &pair);
  pairs_.reserve(found.pairs.size());
  for (const ClearancePair& each : found.pairs) {
    was_judged_[each.clearance] = true;
    Pair& pair = pairs_.emplace_back();
    if (const auto same = known.find(keyOf(each, placement_)); same != known.end()) {
      pair = *same->second;
    }
    static_cast<ClearancePair&>(pair) = each;
    pair.outcome = outcomeOf(each);
  }
  of_step_.assign(outcomes_.size(), {});
  of_span_m_.resize(outcomes_.size(), 0);
  moving_.clear();
  for (Pair& pair : pairs_) {
    pair.moving_a = moving_.add(pair.a, *pair.body_a, placement_);
    pair.moving_b = moving_.add(pair.b, *pair.body_b, placement_);
    pair.seen_moved_m = 0;
    pair.is_near = false;
    const Mat4 now = relative(placement_, pair);
    pair.seen_m = pair.measured_m -
                  displacement(pair.measured_at, now, pair.body_a->centre(), pair.body_a->radius());
    if (pair.seen_m < sampleMatters(pair)) measure(pair, now, placement_, time);
    if (pair.is_near) ++of_step_[pair.outcome].near_pairs;
  }
  closeStep(time);
}

double ClearanceJudge::movedOf(const Pair& pair) const {
  return moving_[pair.moving_a].moved_m + moving_[pair.moving_b].moved_m;
}

/// A distance at a placement matters below this: a new least one, or one that is too near.
double ClearanceJudge::sampleMatters(const Pair& pair) const {
  const ClearanceOutcome& outcome = outcomes_[pair.outcome];
  return std::max({outcome.least.distance_m - kSame_m, outcome.min_m, kTolerance_m});
}

/// Between placements: one that is too near, and in a span that has begun a new least one.
double ClearanceJudge::sweepMatters(const Pair& pair) const {
  const ClearanceOutcome& outcome = outcomes_[pair.outcome];
  const double in_step = of_step_[pair.outcome].least_m - kTolerance_m;
  if (outcome.is_violated) return std::min(of_span_m_[pair.outcome] - kTolerance_m, in_step);
  return std::min(std::max(outcome.min_m, kTolerance_m), in_step);
}

void ClearanceJudge::measure(Pair& pair, const Mat4& at, const CellPlacement& placement,
                             LogTime time) {
  const ClearanceOutcome& outcome = outcomes_[pair.outcome];
  DistanceNeed need;
  need.near_m = std::max(outcome.min_m, kTolerance_m);
  need.exact_below_m = outcome.is_violated ? of_span_m_[pair.outcome]
                                           : std::max(outcome.least.distance_m, need.near_m);
  const BoundedDistance found = search_.bounded(*pair.body_a, *pair.body_b, at, need, &pair.known);
  pair.known = found.contact;
  pair.measured_at = at;
  pair.measured_m = pair.seen_m = found.at_least_m;
  pair.seen_moved_m = movedOf(pair);
  const double distance = found.contact.distance_m;
  pair.is_near = distance < outcome.min_m || !(distance > 0);
  if (distance < need.exact_below_m) {
    offer(pair, found.contact, worldOfB(pair, placement), time);
  }
}

void ClearanceJudge::step(LogTime time, CellPlacement placement) {
  placeMoved(placement, placement_);
  Step step{placement_, placement, time_, time, travelBetween(placement_, placement)};
  moving_.step(placement_, placement, step.travel);
  of_step_.assign(outcomes_.size(), {});
  for (Pair& pair : pairs_) {
    const MovingBody& a = moving_[pair.moving_a];
    const MovingBody& b = moving_[pair.moving_b];
    const double moved = a.step_m + b.step_m;
    if (moved > 0) {
      const double now = pair.seen_m - (movedOf(pair) - pair.seen_moved_m);
      const double between = now - a.bulge_m - b.bulge_m;
      if (pair.is_near || now < sampleMatters(pair) || between < sweepMatters(pair)) {
        look(pair, step, now + moved);
      }
    }
    if (pair.is_near) ++of_step_[pair.outcome].near_pairs;
  }
  closeStep(time);
  time_ = time;
  placement_ = std::move(placement);
}

/// Looks at a pair at the end of a step, and between where that can matter. `before_m`: its
/// distance at the beginning, at least.
void ClearanceJudge::look(Pair& pair, Step& step, double before_m) {
  const LinkTravel travel = relativeTravel(step.travel, pair);
  if (travel.turn_rad <= 0 && travel.slide_m <= 0) {
    pair.seen_m = before_m;
    pair.seen_moved_m = movedOf(pair);
    return;
  }
  const TriangleTree& body = *pair.body_a;
  const MovingBody& a = moving_[pair.moving_a];
  const MovingBody& b = moving_[pair.moving_b];
  const Mat4 start = relative(step.from, pair), end = relative(step.to, pair);
  const double moved =
      std::min(a.step_m + b.step_m, displacement(start, end, body.centre(), body.radius()));
  const double bulge = std::min(a.bulge_m + b.bulge_m, bulgeOf(travel, body, start));
  const double of_spheres =
      lengthOf(a.centre_world - b.centre_world) - body.radius() - pair.body_b->radius();
  const double of_motion =
      pair.measured_m - displacement(pair.measured_at, end, body.centre(), body.radius());
  pair.seen_m = std::max({before_m - moved, of_motion, of_spheres});
  pair.seen_moved_m = movedOf(pair);
  // Along the line between the points that were nearest.
  const Vec3 line = pair.known.on_b - pair.known.on_a;
  if (pair.seen_m < sampleMatters(pair) && lengthOf(line) > kSame_m) {
    const Vec3 direction = line * (1 / lengthOf(line));
    pair.seen_m = std::max(pair.seen_m, gapAlong(direction, body, *pair.body_b, end));
  }
  if (pair.seen_m < sampleMatters(pair)) {
    measure(pair, end, step.to, step.ended);
  } else {
    pair.is_near = false;
  }
  const bool is_jump = !(travel.turn_rad <= kJumpTurn_rad && travel.slide_m <= kJumpSlide_m);
  const double cut = sweepMatters(pair);
  // From either end at most the share of the way that was gone.
  const double between = (before_m + pair.seen_m - moved) / 2 - bulge;
  if (is_jump || !(between < cut)) return;
  Least least;
  least.contact.solid_a = pair.known.solid_a;
  least.contact.solid_b = pair.known.solid_b;
  sweep(pair, step, {{}, step.from, step.to, travel}, cut, least);
  if (least.contact.distance_m < cut) {
    offer(pair, least.contact, least.b_world, step.timeOf(least.at));
  }
}

void ClearanceJudge::sweep(const Pair& pair, Step& step, const Motion& motion, double cut_m,
                           Least& least) {
  const Part part = motion.part;
  TreeSweep swept;
  swept.from = relative(motion.from, pair);
  swept.bulge_m = bulgeOf(motion.travel, *pair.body_a, swept.from);
  if (std::isfinite(swept.bulge_m)) {
    swept.to = relative(motion.to, pair);
    const double before = least.contact.distance_m;
    const bool may_be_nearer =
        search_.sweep(*pair.body_a, *pair.body_b, swept, cut_m, kTolerance_m, least.contact);
    if (least.contact.distance_m < before) {
      const CellPlacement& there = least.contact.at_end ? motion.to : motion.from;
      least.at = least.contact.at_end ? part.next() : part;
      least.b_world = worldOfB(pair, there);
    }
    if (!may_be_nearer) return;
  }
  if (part.depth >= kMaxDepth) return;
  std::optional<CellPlacement> own;
  const CellPlacement* middle = nullptr;
  if (part.depth < kSharedDepth) {
    const auto [found, is_new] = step.middles.try_emplace({part.depth, part.number});
    if (is_new) found->second = halfWay(motion.from, motion.to);
    middle = &found->second;
  } else {
    middle = &own.emplace(halfWay(motion.from, motion.to));
  }
  const LinkTravel& travel = motion.travel;
  const LinkTravel half{travel.turn_rad / 2, travel.slide_m / 2, travel.reach_m};
  const Part first{part.depth + 1, 2 * part.number};
  sweep(pair, step, {first, motion.from, *middle, half}, cut_m, least);
  sweep(pair, step, {first.next(), *middle, motion.to, half}, cut_m, least);
}

void ClearanceJudge::offer(const Pair& pair, const TreeContact& contact, const Mat4& b_world,
                           LogTime time) {
  ClearanceOutcome& outcome = outcomes_[pair.outcome];
  StepOutcome& of_step = of_step_[pair.outcome];
  const double distance = contact.distance_m;
  const bool is_near = distance < outcome.min_m || !(distance > 0);
  if (is_near && distance < of_step.least_m) {
    of_step.least_m = distance;
    of_step.least_at = time;
  }
  if (!(distance < outcome.least.distance_m)) return;
  outcome.least = {distance,
                   nameOfLink(placement_, pair.a),
                   nameOfLink(placement_, pair.b),
                   transformPoint(b_world, contact.on_a),
                   transformPoint(b_world, contact.on_b),
                   time};
}

void ClearanceJudge::dropFindings() {
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    ClearanceOutcome& outcome = outcomes_[i];
    outcome.when = {};
    outcome.spans.clear();
    outcome.violations = outcome.is_violated ? 1 : 0;
    if (outcome.is_violated) {
      outcome.spans.push_back({outcome.last_violation, outcome.last_violation, of_span_m_[i]});
    } else {
      outcome.least = {};
    }
  }
}

void ClearanceJudge::closeStep(LogTime time) {
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    ClearanceOutcome& outcome = outcomes_[i];
    const StepOutcome& of_step = of_step_[i];
    const bool was_near = std::isfinite(of_step.least_m);
    const bool is_near = of_step.near_pairs > 0;
    if ((was_near || is_near) && !outcome.is_violated) {
      const LogTime from = was_near && !is_near ? of_step.least_at : time;
      ++outcome.violations;
      if (outcome.spans.size() < kMaxSpans) outcome.spans.push_back({from, from, outcome.min_m});
      outcome.is_violated = true;
      of_span_m_[i] = std::max(outcome.min_m, kTolerance_m);
    }
    if (!outcome.is_violated) continue;
    of_span_m_[i] = std::min(of_span_m_[i], of_step.least_m);
    const bool is_listed = outcome.violations <= kMaxSpans;
    outcome.last_violation = is_near ? time : std::max(of_step.least_at, outcome.last_violation);
    outcome.when.hit(outcome.last_violation);
    if (is_listed) {
      ClearanceSpan& span = outcome.spans.back();
      span.until = std::max(span.until, outcome.last_violation);
      if (was_near) span.least_m = std::min(span.least_m, of_step.least_m);
    }
    outcome.is_violated = is_near;
  }
}

std::vector<std::size_t> ClearanceJudge::unjudged() const {
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < cell_.clearances.size(); ++i) {
    if (i >= was_judged_.size() || !was_judged_[i]) without.push_back(i);
  }
  return without;
}

}  // namespace rocinante
