#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/clearance/body.h"
#include "core/clearance/cell_motion.h"

namespace rocinante {

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
