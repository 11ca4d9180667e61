#pragma once

#include <string>
#include <vector>

#include "core/document/fault_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Where a file gives a mesh to a link.
struct MeshUse {
  std::string link;
  std::string file;  ///< as it is named
  bool is_collision = false;
  double size_m = 0;  ///< the diagonal of its bounds, scaled
  Place place;
};

/// Warns of meshes that cannot be in the unit that they are read in (`model.scale`): one that is
/// eight times as large as the other kind of geometry of its link, or twenty times as large as what
/// the model's meshes are in the middle; and all of them when that middle is five times the model's
/// reach.
void judgeScale(const Model& model, const std::vector<MeshUse>& uses, FaultList& faults);

}  // namespace rocinante
