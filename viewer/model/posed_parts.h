#pragma once

#include <functional>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// A run of triangles of one material, where it stands in the world. Borrows from scene and model.
struct PosedPart {
  const PosedDevice* device = nullptr;
  std::size_t link = 0;  ///< of the device's model
  const Mesh* mesh = nullptr;
  const MeshPart* part = nullptr;
  Material material;      ///< with the colour that cell or session give it
  Mat4 to_world{1.0};     ///< with the visual's scale
  bool mirrored = false;  ///< to_world turns triangles inside out
};

/// Calls `each` for every part of the visuals of one device: links in the model's order. With
/// `shown_only`, what is hidden is left out.
void forEachPart(const PosedDevice& device, bool shown_only,
                 const std::function<void(const PosedPart&)>& each);

/// A point of a mesh in the world, and the direction of a normal there (unit length; zero stays).
Vec3 worldPoint(const PosedPart& part, const glm::vec3& point);
Vec3 worldNormal(const PosedPart& part, const glm::vec3& normal);

}  // namespace rocinante
