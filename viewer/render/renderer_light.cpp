#include "viewer/passes/shadow_fit.h"
#include "viewer/render/renderer.h"
#include "viewer/render/renderer_impl.h"

namespace rocinante {

/// The map is the same for every view of a frame.
Result<ShadowLookup> Renderer::Impl::drawShadows(const SceneFrame& frame, const LinkLooks& looks,
                                                 const Camera& camera) {
  const auto map = look_passes.shadows();
  if (!map) return map.error();
  const ShadowFit fit = shadowFit(visibleCorners(*frame.scene, catalog, *frame.choice),
                                  Vec3(cell.scene.light_direction), ShadowMap::kSide);
  const Camera light = (*map)->lightCamera(fit);
  if (lights.empty()) {
    const DrawList list = listOf(frame, light, looks);
    std::vector<DrawnSet> sets{{&list, &catalog, &meshes, &textures}};
    DrawList collisions;
    if (looks.anyCollision()) {
      collisions = collisionListOf(frame, light, looks);
      sets.push_back({&collisions, &collision->catalog, &collision->meshes, nullptr});
    }
    (*map)->draw(sets, light);
  }
  return (*map)->lookup(light, fit, camera);
}

Result<Renderer::Impl::ViewLight> Renderer::Impl::drawLight(
    const SceneFrame& frame, const LinkLooks& looks, const Camera& camera, std::size_t number,
    std::span<const DrawnSet> sets, const glm::vec2& origin) {
  const RenderStyle& style = styleOf(frame);
  if (style.shading != Shading::standard) return ViewLight();
  const auto known = lights.find(number);
  if (known != lights.end()) return known->second;
  ViewLight light;
  if (style.shadows) {
    const auto drawn = drawShadows(frame, looks, camera);
    if (!drawn) return drawn.error();
    light.shadows = *drawn;
  }
  if (style.contact && style.edges != EdgeStyle::only) {
    const auto map = look_passes.contact();
    if (!map) return map.error();
    const bool has_ground = cell.scene.grid && frame.choice->layerVisible("grid");
    const auto drawn =
        (*map)->draw(number, sets, camera, has_ground ? cell.scene.grid_size_m : 0.0, origin);
    if (!drawn) return drawn.error();
    light.contact = *drawn;
  }
  return lights.emplace(number, light).first->second;
}

}  // namespace rocinante
