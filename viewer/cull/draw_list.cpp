#include "viewer/cull/draw_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/math/transform.h"
#include "viewer/cull/cull_sphere.h"

namespace rocinante {
namespace {

/// Items below this opacity are drawn as translucent.
constexpr float kOpaqueAlpha = 0.999F;

bool mirrors(const Mat4& m) {
  const Vec3 x(m[0]);
  const Vec3 y(m[1]);
  const Vec3 z(m[2]);
  return x.x * (y.y * z.z - y.z * z.y) + x.y * (y.z * z.x - y.x * z.z) +
             x.z * (y.x * z.y - y.y * z.x) <
         0;
}

Mat4 visualWorld(const Mat4& link_world, const Visual& visual) {
  // Most visuals have an identity origin; skip the product.
  const bool moved =
      visual.origin.position != Vec3(0) || visual.origin.orientation != Quat(1, 0, 0, 0);
  const Mat4 at = moved ? link_world * matrixOf(visual.origin) : link_world;
  return visual.scale != Vec3(1) ? at * scaleMatrix(visual.scale) : at;
}

glm::vec4 colorOf(std::uint32_t rgba) {
  return {static_cast<float>(rgba >> 24 & 255U) / 255.0F,
          static_cast<float>(rgba >> 16 & 255U) / 255.0F,
          static_cast<float>(rgba >> 8 & 255U) / 255.0F, static_cast<float>(rgba & 255U) / 255.0F};
}

std::uint64_t triangleCount(const DrawItem& item, const MeshPart& part) {
  if (item.coarse == nullptr) return part.index_count / 3;
  return (item.coarse->two_sided_count + item.coarse->one_sided_count) / 3;
}

/// Makes of the material's opacity what its alpha mode means.
void applyAlphaMode(DrawItem& item) {
  const Material& material = *item.material;
  if (material.alpha_mode == AlphaMode::blend) return;
  const float opacity = material.diffuse.a;
  item.diffuse.a = 1.0F;
  if (material.alpha_mode == AlphaMode::opaque) return;
  if (!(opacity >= material.alpha_cutoff)) {
    item.diffuse.a = 0.0F;  // no alpha of a texture is enough
  } else if (item.texture >= 0) {
    item.is_cut = true;
    item.cutoff = opacity > 0.0F ? material.alpha_cutoff / opacity : 0.0F;
  }
}

void applyLook(const PartLook& look, DrawItem& item) {
  if (look.tone) {
    item.diffuse = glm::vec4(glm::vec3(*look.tone), look.tone->a * item.diffuse.a);
    item.texture = -1;
    item.is_cut = false;
    item.tinted = false;
  }
  item.diffuse.a *= look.opacity;
}

/// Calls each(visual, device number, link number, mesh number) for every visible visual, except of
/// devices and links outside the view of `camera` (null: no culling).
template <class Each>
void forEachVisual(const PosedScene& scene, const SceneCatalog& catalog, const ViewChoice& choice,
                   const LinkLooks& looks, DrawnGeometry geometry, const Camera* camera,
                   const Each& each) {
  for (std::uint32_t d = 0; d < scene.devices.size(); ++d) {
    const PosedDevice& device = scene.devices[d];
    if (device.model == nullptr) continue;
    const LinkReaches* const reaches = camera == nullptr ? nullptr : catalog.reaches(*device.model);
    if (reaches != nullptr && !mayBeSeen(*camera, deviceSphere(device, *reaches))) continue;
    const bool asks_parts = choice.choosesParts(device);
    const auto whole = choice.chosenWhole(device);
    for (std::uint32_t l = 0; l < device.model->links.size(); ++l) {
      const Link& link = device.model->links[l];
      const auto& drawn = geometry == DrawnGeometry::visuals ? link.visuals : link.collisions;
      if (drawn.empty()) continue;
      if (reaches != nullptr && !mayBeSeen(*camera, linkSphere(device, l, (*reaches)[l]))) continue;
      if (!(asks_parts || choice.linkVisible(device, l, whole))) continue;
      if (looks.anyCollision() && !looks.draws(geometry, device, l)) continue;
      for (const Visual& visual : drawn) {
        const auto mesh = catalog.meshNumber(visual.mesh.get());
        if (mesh) each(visual, d, l, *mesh);
      }
    }
  }
}

template <class Each>
void forEachPart(const Visual& visual, const CatalogMesh& mesh, const Each& each) {
  if (visual.mesh_parts.empty()) {
    for (std::uint32_t part = 0; part < mesh.parts.size(); ++part) each(part);
  } else {
    for (const std::size_t part : visual.mesh_parts) {
      if (part < mesh.parts.size()) each(static_cast<std::uint32_t>(part));
    }
  }
}

/// Numbers looks by first appearance; all looks beyond the limit share the last number.
class LookNumbers {
 public:
  static constexpr std::uint32_t kMax = 64;

  std::uint32_t of(const DrawItem& item) {
    if (latest_ < looks_.size() && sameLook(*looks_[latest_], item)) return latest_;
    const std::uint32_t hash = hashOf(item);
    for (latest_ = 0; latest_ < looks_.size(); ++latest_) {
      if (hashes_[latest_] == hash && sameLook(*looks_[latest_], item)) return latest_;
    }
    if (latest_ < kMax) {
      looks_.push_back(&item);
      hashes_.push_back(hash);
    }
    return latest_;
  }

 private:
  /// Hash of the colour only: few items of one colour differ otherwise.
  static std::uint32_t hashOf(const DrawItem& item) {
    std::uint32_t hash = 0;
    for (int i = 0; i < 4; ++i) {
      hash = (hash ^ std::bit_cast<std::uint32_t>(item.diffuse[i])) * 0x9E3779B1U;
      hash ^= hash >> 15U;
    }
    return hash;
  }

  std::vector<const DrawItem*> looks_;
  std::vector<std::uint32_t> hashes_;
  std::uint32_t latest_ = 0;
};

/// Stable sort by state. Sorts small keys because items are large.
void sortByState(std::vector<DrawItem>& items, std::vector<DrawItem>& spare) {
  // Rank and texture (none first), then mesh and index.
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  std::vector<Key> keys;
  keys.reserve(items.size());
  LookNumbers looks;
  for (const DrawItem& item : items) {
    const std::uint32_t group = item.batched ? ~LookNumbers::kMax + looks.of(item) : item.mesh;
    const auto texture = static_cast<std::uint32_t>(item.texture + 1);
    keys.emplace_back(std::uint64_t{item.coplanar_rank} << 32U | texture,
                      std::uint64_t{group} << 32U | keys.size());
  }
  if (std::is_sorted(keys.begin(), keys.end())) return;
  std::sort(keys.begin(), keys.end());
  spare.clear();
  spare.reserve(items.size());
  for (const Key& key : keys) spare.push_back(items[key.second & 0xFFFFFFFFU]);
  std::swap(items, spare);
}

}  // namespace

bool tooSmall(const PartSphere& sphere, const Camera& camera, const DetailLevel& level) {
  if (level.cull_below_px <= 0) return false;
  const double depth = camera.depthOf(sphere.center);
  // A sphere around the eye is not small, whatever the depth of its centre.
  if (!camera.orthographic() && depth <= sphere.radius_m) return false;
  return 2 * sphere.radius_m < level.cull_below_px * camera.metersPerPixel(depth);
}

const CoarsePart* coarseVersion(const CatalogPart& part, const PartSphere& sphere,
                                const Camera& camera, const DetailLevel& level) {
  if (level.geometry_error_px <= 0 || part.coarser.empty()) return nullptr;
  const double nearest = std::max(camera.depthOf(sphere.center) - sphere.radius_m, camera.near());
  const double allowed_m = level.geometry_error_px * camera.metersPerPixel(nearest);
  const CoarsePart* chosen = nullptr;
  for (const CoarsePart& version : part.coarser) {
    if (version.error_m * sphere.scale > allowed_m) break;
    chosen = &version;
  }
  return chosen;
}

bool sameLook(const DrawItem& a, const DrawItem& b) {
  return a.diffuse == b.diffuse &&
         (a.material == b.material || (a.material->specular == b.material->specular &&
                                       a.material->emission == b.material->emission &&
                                       a.material->shininess == b.material->shininess));
}

void DrawList::clear() {
  for (auto* items : {&opaque, &translucent, &wireframe, &ghosts}) items->clear();
  triangles = 0;
}

DrawList makeDrawList(const PosedScene& scene, const SceneCatalog& catalog,
                      const ViewChoice& choice, const Camera& camera,
                      const std::vector<std::uint8_t>& translucent_textures, const LinkLooks& looks,
                      DrawnGeometry geometry, const DetailLevel& detail, Culling culling) {
  DrawList list;
  makeDrawList(list, scene, catalog, choice, camera, translucent_textures, looks, geometry, detail,
               culling);
  return list;
}

void makeDrawList(DrawList& list, const PosedScene& scene, const SceneCatalog& catalog,
                  const ViewChoice& choice, const Camera& camera,
                  const std::vector<std::uint8_t>& translucent_textures, const LinkLooks& looks,
                  DrawnGeometry geometry, const DetailLevel& detail, Culling culling) {
  static const Material kPlain;
  list.clear();
  forEachVisual(
      scene, catalog, choice, looks, geometry, culling == Culling::by_device ? &camera : nullptr,
      [&](const Visual& visual, std::uint32_t d, std::uint32_t l, std::uint32_t mesh_number) {
        const PosedDevice& device = scene.devices[d];
        const CatalogMesh& mesh = catalog.meshes()[mesh_number];
        const Mat4 world = visualWorld(device.link_world[l], visual);
        const double scale = scaleBound(world);
        const bool mirrored = mirrors(world);
        forEachPart(visual, mesh, [&](std::uint32_t part) {
          const CatalogPart& known = mesh.parts[part];
          const MeshPart& run = mesh.mesh->parts[part];
          if (run.index_count == 0) return;
          if (choice.choosesParts(device) && !choice.partVisible(device, l, run.group)) return;
          const Vec3 center = transformPoint(world, known.center);
          const PartSphere sphere{center, known.radius * scale, scale};
          if (!camera.sees(center, sphere.radius_m)) return;
          if (tooSmall(sphere, camera, detail)) return;

          DrawItem item;
          item.mesh = mesh_number;
          item.part = part;
          item.device = d;
          item.link = l;
          item.world = world;
          item.mirrored = mirrored;
          item.coplanar_rank = known.coplanar_rank;
          item.coarse = coarseVersion(known, sphere, camera, detail);
          item.material = visual.material ? &*visual.material
                          : run.material < mesh.mesh->materials.size()
                              ? &mesh.mesh->materials[run.material]
                              : &kPlain;
          item.diffuse = item.material->diffuse;
          const auto color =
              device.has_parts ? device.partColor(l, run.group) : device.link_color[l];
          item.tinted = !mesh.mesh->colors.empty() && !visual.material && !color;
          if (const auto texture = catalog.textureNumber(*item.material)) {
            item.texture = static_cast<std::int32_t>(*texture);
          }
          if (color) {
            // A colour that was set replaces the material, including its texture.
            item.diffuse = colorOf(*color);
            item.texture = -1;
          } else {
            applyAlphaMode(item);
          }
          PartLook look;
          if (looks.any()) {
            look = looks.lookOf(geometry, scene, d, l, run.group);
            applyLook(look, item);
          }
          item.outlined = looks.anyOutlined() && looks.outlined(device, l, run.group);
          const bool holes = item.texture >= 0 && !item.is_cut &&
                             static_cast<std::size_t>(item.texture) < translucent_textures.size() &&
                             translucent_textures[static_cast<std::size_t>(item.texture)] != 0;
          item.translucent = item.diffuse.a < kOpaqueAlpha || holes;
          item.batched = item.texture < 0 && item.coarse == nullptr && mesh.isSmall();
          item.distance =
              camera.orthographic() ? camera.depthOf(center) : lengthOf(center - camera.eye());
          // NaN has no order.
          if (std::isnan(item.distance)) item.distance = 0;
          if (item.diffuse.a <= 0.0F) return;
          list.triangles += triangleCount(item, run);
          (look.wireframe     ? list.wireframe
           : look.ghost       ? list.ghosts
           : item.translucent ? list.translucent
                              : list.opaque)
              .push_back(item);
        });
      });
  sortByState(list.opaque, list.spare);
  sortFromBackToFront(list.translucent, catalog, camera);
}

std::vector<Vec3> visibleCorners(const PosedScene& scene, const SceneCatalog& catalog,
                                 const ViewChoice& choice, const DeviceNames* devices) {
  std::vector<Vec3> corners;
  forEachVisual(
      scene, catalog, choice, LinkLooks(), DrawnGeometry::visuals, nullptr,
      [&](const Visual& visual, std::uint32_t d, std::uint32_t l, std::uint32_t mesh_number) {
        if (devices != nullptr && !devices->contains(scene.devices[d].name)) return;
        const CatalogMesh& mesh = catalog.meshes()[mesh_number];
        const Mat4 world = visualWorld(scene.devices[d].link_world[l], visual);
        forEachPart(visual, mesh, [&](std::uint32_t part) {
          const CatalogPart& known = mesh.parts[part];
          const MeshPart& run = mesh.mesh->parts[part];
          if (run.index_count == 0) return;
          const PosedDevice& device = scene.devices[d];
          if (choice.choosesParts(device) && !choice.partVisible(device, l, run.group)) return;
          for (unsigned corner = 0; corner < 8; ++corner) {
            const Vec3 sign((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                            (corner & 4U) != 0 ? 1 : -1);
            corners.push_back(transformPoint(world, known.center + sign * known.half));
          }
        });
      });
  return corners;
}

}  // namespace rocinante
