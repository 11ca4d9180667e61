#pragma once

#include <map>
#include <memory>
#include <utility>

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

}  // namespace rocinante
