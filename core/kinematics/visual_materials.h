#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "core/kinematics/model.h"

namespace rocinante {

/// What a material script of Gazebo's own collection draws, by its name.
struct GazeboColor {
  glm::vec4 diffuse{};
  glm::vec3 emission{0.0F, 0.0F, 0.0F};
};

/// Of "Gazebo/Red" and the like (docs/meshes.md, section "SDF"); empty for other scripts, and for
/// those of the collection that are pictures.
std::optional<GazeboColor> gazeboColor(std::string_view script);

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
