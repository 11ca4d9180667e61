#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>

namespace rocinante {

/// What a material script of Gazebo's own collection draws, by its name.
struct GazeboColor {
  glm::vec4 diffuse{};
  glm::vec3 emission{0.0F, 0.0F, 0.0F};
};

/// Of "Gazebo/Red" and the like (docs/meshes.md, section "SDF"); empty for other scripts, and for
/// those of the collection that are pictures.
std::optional<GazeboColor> gazeboColor(std::string_view script);

}  // namespace rocinante
