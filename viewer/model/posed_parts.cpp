#include "core/math/transform.h"
#include "viewer/model/model_writers.h"

namespace rocinante {
namespace {

Material materialOf(const PosedDevice& device, std::size_t link, const Visual& visual,
                    const MeshPart& part) {
  Material material;
  if (visual.material) {
    material = *visual.material;
  } else if (part.material < visual.mesh->materials.size()) {
    material = visual.mesh->materials[part.material];
  }
  if (const auto rgba = device.link_color[link]) {
    // As drawn: a colour that was set replaces the material, including its texture.
    for (int i = 0; i < 4; ++i) {
      material.diffuse[i] = static_cast<float>(*rgba >> (24 - 8 * i) & 0xFFU) / 255.0F;
    }
    material.diffuse_map.clear();
    material.diffuse_bytes.reset();
    material.alpha_mode = AlphaMode::blend;
  }
  return material;
}

}  // namespace

void forEachPart(const PosedDevice& device, bool shown_only,
                 const std::function<void(const PosedPart&)>& each) {
  for (std::size_t link = 0; link < device.model->links.size(); ++link) {
    if (shown_only && !device.link_visible[link]) continue;
    for (const Visual& visual : device.model->links[link].visuals) {
      if (!visual.mesh) continue;
      PosedPart posed;
      posed.device = &device;
      posed.link = link;
      posed.mesh = visual.mesh.get();
      posed.to_world =
          device.link_world[link] * matrixOf(visual.origin) * scaleMatrix(visual.scale);
      posed.mirrored = visual.scale.x * visual.scale.y * visual.scale.z < 0.0;
      const auto give = [&](const MeshPart& part) {
        if (part.index_count == 0) return;
        posed.part = &part;
        posed.material = materialOf(device, link, visual, part);
        posed.tinted = !visual.mesh->colors.empty() && !visual.material &&
                       !device.link_color[link].has_value();
        each(posed);
      };
      if (visual.mesh_parts.empty()) {
        for (const MeshPart& part : visual.mesh->parts) give(part);
      }
      for (const std::size_t part : visual.mesh_parts) {
        if (part < visual.mesh->parts.size()) give(visual.mesh->parts[part]);
      }
    }
  }
}

Vec3 worldPoint(const PosedPart& part, const glm::vec3& point) {
  return transformPoint(part.to_world, Vec3(point));
}

Vec3 worldNormal(const PosedPart& part, const glm::vec3& normal) {
  // By the cofactor matrix, so that normals stay perpendicular under uneven scales.
  const Vec3 x(part.to_world[0]), y(part.to_world[1]), z(part.to_world[2]);
  Vec3 turned = crossOf(y, z) * static_cast<double>(normal.x) +
                crossOf(z, x) * static_cast<double>(normal.y) +
                crossOf(x, y) * static_cast<double>(normal.z);
  if (part.mirrored) turned = -turned;
  return normalized(turned).value_or(Vec3{0, 0, 0});
}

}  // namespace rocinante
