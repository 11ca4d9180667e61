#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "core/clearance/cell_motion.h"
#include "core/clearance/triangle_tree.h"

namespace rocinante {

/// How far one link's surface has moved in the world, at most.
struct MovingBody {
  LinkId link;
  const TriangleTree* body = nullptr;
  double moved_m = 0;   ///< since begin(), summed over the steps
  double step_m = 0;    ///< in the last step; 0: it has stood still
  double bulge_m = 0;   ///< how far it left the straight way in the last step
  Vec3 centre_world{};  ///< of the body's sphere, now
};

/// The bodies of a cell, each followed once for all the pairs it is in: two bodies have come nearer
/// by no more than the sum of what each has moved. One thread.
class MovingBodies {
 public:
  void clear();
  /// The index of a link's body; the same for the same link.
  std::size_t add(LinkId link, const TriangleTree& body, const CellPlacement& placement);
  void step(const CellPlacement& from, const CellPlacement& to, const CellTravel& travel);
  const MovingBody& operator[](std::size_t i) const { return bodies_[i]; }

 private:
  std::vector<MovingBody> bodies_;
  std::map<LinkId, std::size_t> by_link_;
};

}  // namespace rocinante
