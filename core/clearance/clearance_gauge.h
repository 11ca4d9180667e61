#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/cell/cell.h"
#include "core/clearance/clearance_pairs.h"
#include "core/clearance/tree_distance.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A distance as reports and tables have it: rounded to 0.01 mm, in metres. 0 for
/// penetration; else at least 0.01 mm.
double roundedClearance(double metres);

/// Two devices that a clearance keeps apart (or one and itself).
struct ClearanceGap {
  std::size_t clearance = 0;  ///< into Cell::clearances
  std::string device_a, device_b;
};

/// Where the distance of such two is found.
struct GapPlace {
  std::size_t clearance = 0;  ///< into Cell::clearances
  double distance_m = 0;
  Vec3 on_a{}, on_b{};  ///< the nearest points, in the world
};

/// Measures the distance of every two devices that a cell's clearances name, in one state after
/// another: the least of their links, exact (where ClearanceJudge only looks for the least of a
/// session). A state like the one before is fast: what cannot have become the nearest is not
/// searched for. The same bits on every processor. Memory grows with the pairs, not with time. The
/// cell must outlive it. One thread.
class ClearanceGauge {
 public:
  /// Which two devices are measured; empty: all.
  using Chosen = std::function<bool(std::string_view, std::string_view)>;

  explicit ClearanceGauge(const Cell& cell, Chosen chosen = {});

  /// Adds the gaps of a state, without measuring. Cheap where no device came, went or changed its
  /// carrier.
  void notice(const SessionState& state);
  /// Measures: `distances_m` is then as long as gaps(), NaN where a device is not there.
  void measure(const SessionState& state, std::vector<double>& distances_m);
  /// The same with the places: as gaps(), without those of which a device is not there.
  std::vector<GapPlace> places(const SessionState& state);

  /// In order of clearances and names. New ones may come in between with every state.
  std::vector<ClearanceGap> gaps() const;
  /// Clearances without any gap so far.
  std::vector<std::size_t> unmeasured() const;
  bool hadTooMany() const { return had_too_many_; }

 private:
  using GapKey = std::tuple<std::size_t, std::string, std::string>;
  struct Pair : ClearancePair {
    bool is_measured = false;
    Mat4 measured_at{1.0};  ///< a in b's space then
    double measured_m = 0;  ///< then, at least
    bool is_exact = false;
    TreeContact known;
  };
  struct Group {
    std::vector<Pair> pairs;
    std::size_t nearest = 0;  ///< of the pairs, the last time
  };

  CellPlacement placed(const SessionState& state);
  void arrange(const PosedScene& scene, const CellPlacement& placement);
  double measure(Group& group, const CellPlacement& placement);
  double measure(Pair& pair, const CellPlacement& placement, double best_m);

  const Cell& cell_;
  Chosen chosen_;
  BodyStore bodies_;
  TreeSearch search_;
  std::string structure_;  ///< of the last state noticed
  bool is_arranged_ = false, had_too_many_ = false;
  CellPlacement placement_;
  std::map<GapKey, Group> groups_;
};

}  // namespace rocinante
