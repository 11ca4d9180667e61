#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "core/clearance/cell_motion.h"
#include "core/clearance/triangle_tree.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// The solids of a link in its own space: its collision geometry, or its visuals' triangles when it
/// has none. Spheres and capsules are exact, and so are boxes; a cylinder has as many sides as it
/// needs to be within 0.01 mm of round up to a radius of 2 m (its corners lie on the circle).
std::vector<Solid> solidsOf(const Link& link);

/// The trees of a cell's links, each built once, when first asked for. Keeps nothing of the models,
/// which must outlive it. One thread.
class BodyStore {
 public:
  /// Null when the link has no geometry.
  const TriangleTree* find(const Model& model, std::size_t link);

 private:
  std::map<std::pair<const Model*, std::size_t>, std::unique_ptr<const TriangleTree>> bodies_;
};

/// Two links that a `[[clearance]]` keeps apart.
struct ClearancePair {
  std::size_t clearance = 0;  ///< into Cell::clearances
  LinkId a, b;
  const TriangleTree* body_a = nullptr;  ///< of a BodyStore
  const TriangleTree* body_b = nullptr;
  std::optional<LinkId> common;  ///< the last link that both hang from; empty: the world
};

struct ClearancePairs {
  std::vector<ClearancePair> pairs;  ///< in the order of clearances, devices and links
  std::vector<std::size_t> empty;    ///< clearances without any pair
  bool too_many = false;             ///< more than kMaxClearancePairs: the rest is left out
};
inline constexpr std::size_t kMaxClearancePairs = 200'000;

/// The pairs of links with geometry that the patterns of the cell's clearances name, each once in a
/// clearance. Left out: links of one device that are joined by one joint that moves, or by fixed
/// joints alone; a link and what is carried on it; what `except` names. `scene` tells the layers.
ClearancePairs clearancePairs(const Cell& cell, const PosedScene& scene,
                              const CellPlacement& placement, BodyStore& bodies);

}  // namespace rocinante
