#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/clearance/clearance_pairs.h"
#include "core/clearance/moving_bodies.h"
#include "core/clearance/tree_distance.h"
#include "core/report/time_histogram.h"

namespace rocinante {

/// How near two links came, where and when.
struct LeastClearance {
  double distance_m = std::numeric_limits<double>::infinity();  ///< 0: penetrating
  std::string link_a, link_b;                                   ///< "DEVICE/LINK"
  Vec3 on_a{}, on_b{};                                          ///< in the world
  LogTime time{};
};

/// A span in which two devices were nearer than allowed.
struct ClearanceSpan {
  LogTime from{}, until{};
  double least_m = 0;
};

/// What one `[[clearance]]` found about two devices (or one and itself).
struct ClearanceOutcome {
  std::size_t clearance = 0;  ///< into Cell::clearances
  std::string device_a, device_b;
  double min_m = 0;
  LeastClearance least;
  std::uint64_t violations = 0;      ///< spans
  std::vector<ClearanceSpan> spans;  ///< the first kMaxSpans of them
  LogTime last_violation{};
  TimeHistogram when;        ///< placements in violation
  bool is_violated = false;  ///< now
};

/// Judges the distances between the links of a cell over one placement after another.
///
/// **At the placements** the least distance of every two devices is exact (within kSame_m).
///
/// **Between placements** every joint goes evenly from one value to the next (halfWay()). Of this
/// motion a judge finds what is nearer than allowed: whether a pair comes below `min_m` (or
/// touches), and then the least distance within kTolerance_m. A distance that is reported below
/// `min_m` occurs at a moment of that motion, and none is smaller by more than the tolerance. What
/// stays above `min_m` between two placements is not looked for: above it the least distance is
/// that of the placements.
///
/// **How.** A body is followed once for all its pairs (MovingBodies). A pair is looked at again
/// only when both bodies together have moved, since it was last looked at, as far as what was left
/// between its distance and one that matters. Then in turn: the motion of one against the other
/// since it was measured, their spheres, and last their trees (TreeSearch::bounded()), beginning
/// with the triangles that were nearest and ending as soon as nothing nearer matters. A step is
/// swept (TreeSearch::sweep()) only when the distances at its ends, the way between them and the
/// bulge of the arcs leave room for one below `min_m`: with each corner on a straight line, give or
/// take the bulge, (w^2 D + 2 w v) / 8 for joints that turn by w and slide by v in all and reach as
/// far as D; where that still leaves room the step is halved, which quarters the bulge.
///
/// A step in which the links of a pair turn by more than half a turn or slide by more than 2 m is a
/// jump: judged at its end alone. So are devices that appear, disappear or change their carrier.
///
/// The same bits on every processor. Memory grows with the pairs, not with time. The cell must
/// outlive it. One thread.
class ClearanceJudge {
 public:
  static constexpr double kTolerance_m = 5e-5;
  static constexpr double kSame_m = 1e-9;  ///< distances this near count as one
  static constexpr std::size_t kMaxSpans = 100;

  explicit ClearanceJudge(const Cell& cell) : cell_(cell) {}

  /// Begins anew with a placement, keeping what was found.
  void begin(LogTime time, const PosedScene& scene, CellPlacement placement);
  /// The next placement, of the same structure; its `link_world` is not read.
  void step(LogTime time, CellPlacement placement);

  /// Forgets what was found, but for the spans that go on.
  void dropFindings();

  bool hasBegun() const { return has_begun_; }
  const CellPlacement& placement() const { return placement_; }
  const std::vector<ClearanceOutcome>& outcomes() const { return outcomes_; }
  /// Clearances that never had two links with geometry.
  std::vector<std::size_t> unjudged() const;
  bool hadTooMany() const { return had_too_many_; }

 private:
  struct Pair : ClearancePair {
    std::size_t outcome = 0;
    std::size_t moving_a = 0, moving_b = 0;  ///< into MovingBodies
    Mat4 measured_at{1.0};                   ///< a in b's space when it was last measured
    double measured_m = 0;                   ///< then, at least
    double seen_m = 0;                       ///< when it was last looked at, at least
    double seen_moved_m = 0;                 ///< what both bodies had moved then
    TreeContact known;
    bool is_near = false;  ///< nearer than allowed, now
  };
  struct Step;
  /// The moment `number / 2^depth` of a step, or what follows it up to `next()`.
  struct Part {
    std::uint32_t depth = 0;
    std::uint64_t number = 0;
    Part next() const { return {depth, number + 1}; }
  };
  struct Least {
    TreeContact contact;
    Part at;
    Mat4 b_world{1.0};
  };
  struct Motion {
    Part part;
    const CellPlacement& from;
    const CellPlacement& to;
    LinkTravel travel;  ///< of the pair, at most
  };

  std::size_t outcomeOf(const ClearancePair& pair);
  Mat4 relative(const CellPlacement& placement, const Pair& pair) const;
  double movedOf(const Pair& pair) const;
  double sampleMatters(const Pair& pair) const;
  double sweepMatters(const Pair& pair) const;
  void measure(Pair& pair, const Mat4& at, const CellPlacement& placement, LogTime time);
  void look(Pair& pair, Step& step, double before_m);
  void sweep(const Pair& pair, Step& step, const Motion& motion, double cut_m, Least& least);
  void offer(const Pair& pair, const TreeContact& contact, const Mat4& b_world, LogTime time);
  void closeStep(LogTime time);

  const Cell& cell_;
  BodyStore bodies_;
  TreeSearch search_;
  bool has_begun_ = false, had_too_many_ = false;
  LogTime time_{};
  CellPlacement placement_;
  MovingBodies moving_;
  std::vector<Pair> pairs_;
  std::vector<bool> was_judged_;  ///< by clearance
  std::vector<ClearanceOutcome> outcomes_;
  std::map<std::tuple<std::size_t, std::string, std::string>, std::size_t> outcome_by_names_;
  /// By outcome, of the step at hand: pairs too near at its end, the least distance in it below the
  /// allowed one, and when that was.
  struct StepOutcome {
    std::size_t near_pairs = 0;
    double least_m = std::numeric_limits<double>::infinity();
    LogTime least_at{};
  };
  std::vector<StepOutcome> of_step_;
  std::vector<double> of_span_m_;  ///< by outcome: the least distance of the span at hand
};

}  // namespace rocinante
