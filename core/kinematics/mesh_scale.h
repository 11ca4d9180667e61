#pragma once

#include <string>
#include <vector>

#include "core/document/fault_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// A mesh that a file gives to a link.
struct MeshUse {
  std::string link;
  std::string file;  ///< as it is named
  bool is_collision = false;
  double size_m = 0;  ///< the diagonal of its bounds, scaled
  Place place;
};

/// Warns of meshes that cannot be in the unit that they are read in (`model.scale`): a mesh eight
/// times as large as the other kind of geometry of its link, or twenty times the model's median
/// mesh; and all meshes when the median is five times the model's reach.
void judgeScale(const Model& model, const std::vector<MeshUse>& uses, FaultList& faults);

}  // namespace rocinante
