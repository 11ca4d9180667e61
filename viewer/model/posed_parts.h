#pragma once

#include <functional>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// A run of triangles of one material with its world transform. Borrows from scene and model.
struct PosedPart {
  const PosedDevice* device = nullptr;
  std::size_t link = 0;  ///< of the device's model
  const Mesh* mesh = nullptr;
  const MeshPart* part = nullptr;
  Material material;      ///< with overrides of cell or session
  bool tinted = false;    ///< by the mesh's vertex colours
  Mat4 to_world{1.0};     ///< with the visual's scale
  bool mirrored = false;  ///< to_world flips the winding
};

/// Calls `each` for every part of one device's visuals, links in model order. `shown_only` leaves
/// out hidden ones.
void forEachPart(const PosedDevice& device, bool shown_only,
                 const std::function<void(const PosedPart&)>& each);

/// A mesh point in world space, and a normal there (unit length; zero stays zero).
Vec3 worldPoint(const PosedPart& part, const glm::vec3& point);
Vec3 worldNormal(const PosedPart& part, const glm::vec3& normal);

}  // namespace rocinante
