#pragma once

#include <functional>
#include <vector>

#include "core/kinematics/model.h"

namespace rocinante {

/// The parts of a mesh whose file gives them a material, and the others; in order.
struct PartsByMaterial {
  std::vector<std::size_t> own, plain;
};
PartsByMaterial partsByMaterial(const Mesh& mesh);

/// `visual` with `change` made to the material of each of its parts: as one visual, or as several
/// where its mesh has several materials.
std::vector<Visual> withChangedMaterials(const Visual& visual,
                                         const std::function<void(Material&)>& change);

}  // namespace rocinante
