#include "recorder/gltf/gltf_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/mesh.h"

namespace rocinante {
namespace {

constexpr std::size_t kBatch = 4096;

/// Gives `count` elements of N floats, batch by batch.
template <std::size_t N, class MakeElement>
Status giveFloats(std::size_t count, const UseBytes& use, const MakeElement& element) {
  std::vector<std::array<float, N>> batch;
  batch.reserve(kBatch);
  for (std::size_t i = 0; i < count; ++i) {
    batch.push_back(element(i));
    if (batch.size() < kBatch && i + 1 < count) continue;
    if (Status used = use(std::as_bytes(std::span(batch))); !used) return used;
    batch.clear();
  }
  return {};
}

/// Unit length, which glTF demands; our own lighting also takes others.
glm::vec3 unitNormal(const glm::vec3& normal) {
  const float length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  if (!(length > 1e-20F) || !std::isfinite(length)) return {0, 0, 1};
  return std::abs(length - 1) < 1e-3F ? normal : normal / length;
}

std::array<float, 256> makeLinearLevels() {
  std::array<float, 256> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] = static_cast<float>(linearOfSrgb(static_cast<double>(i) / 255.0));
  }
  return levels;
}

Material materialOf(const PosedDevice& device, std::size_t link, const Visual& visual,
                    const MeshPart& part) {
  Material material;
  if (visual.material) {
    material = *visual.material;
  } else if (part.material < visual.mesh->materials.size()) {
    material = visual.mesh->materials[part.material];
  }
  const auto color =
      device.has_parts ? device.partColor(link, part.group) : device.link_color[link];
  if (color) {
    // As drawn: a colour that was set replaces the material, including its texture.
    for (int i = 0; i < 4; ++i) {
      material.diffuse[i] = static_cast<float>(*color >> (24 - 8 * i) & 0xFFU) / 255.0F;
    }
    material.diffuse_map.clear();
    material.diffuse_bytes.reset();
    material.alpha_mode = AlphaMode::blend;
  }
  if (device.link_look.empty()) return material;
  const float opacity = device.partLook(link, part.group).opacity.value_or(1.0F);
  if (opacity >= 1.0F) return material;
  if (material.alpha_mode != AlphaMode::blend) material.diffuse.a = 1.0F;
  material.alpha_mode = AlphaMode::blend;
  material.diffuse.a *= opacity;
  return material;
}

}  // namespace

GltfMeshes::Geometry& GltfMeshes::geometryOf(const Mesh& mesh) {
  const auto [known, is_new] = geometry_.try_emplace(&mesh);
  Geometry& geometry = known->second;
  if (!is_new) return geometry;
  const std::size_t count = mesh.vertices.size();
  std::array<float, 3> min{}, max{};
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3& position = mesh.vertices[i].position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float at = position[static_cast<int>(axis)];
      min[axis] = i == 0 ? at : std::min(min[axis], at);
      max[axis] = i == 0 ? at : std::max(max[axis], at);
    }
  }
  constexpr std::size_t kStride = 24;
  const std::size_t vertices = binary_.addView(
      count * kStride, GltfBinary::Target::vertices, kStride, [&mesh, count](const UseBytes& use) {
        return giveFloats<6>(count, use, [&](std::size_t i) {
          const glm::vec3& at = mesh.vertices[i].position;
          const glm::vec3 up = unitNormal(mesh.vertices[i].normal);
          return std::array<float, 6>{at.x, at.y, at.z, up.x, up.y, up.z};
        });
      });
  geometry.positions =
      binary_.addAccessor(vertices, 0, kGltfFloat, "VEC3", count, accessorRange(min, max));
  geometry.normals = binary_.addAccessor(vertices, 12, kGltfFloat, "VEC3", count);
  geometry.indices = binary_.addView(
      mesh.indices.size() * 4, GltfBinary::Target::indices, 0,
      [&mesh](const UseBytes& use) { return use(std::as_bytes(std::span(mesh.indices))); });
  return geometry;
}

void GltfMeshes::addColors(const Mesh& mesh, Geometry& geometry) {
  if (geometry.colors) return;
  const std::size_t count = mesh.vertices.size();
  const std::size_t view = binary_.addView(
      count * 16, GltfBinary::Target::vertices, 0, [&mesh, count](const UseBytes& use) {
        const std::array<float, 256> levels = makeLinearLevels();
        return giveFloats<4>(count, use, [&](std::size_t i) {
          const std::uint32_t color = i < mesh.colors.size() ? mesh.colors[i] : 0xFFFFFFFF;
          return std::array<float, 4>{levels[color >> 24U], levels[color >> 16U & 0xFFU],
                                      levels[color >> 8U & 0xFFU], 1.0F};
        });
      });
  geometry.colors = binary_.addAccessor(view, 0, kGltfFloat, "VEC4", count);
}

std::size_t GltfMeshes::placesOf(const Mesh& mesh, Geometry& geometry, const Material& material) {
  const MapPlacing placing(material);
  const glm::vec2 u = placing.along_u, v = placing.along_v, offset = placing.offset;
  const auto [known, is_new] =
      geometry.places.try_emplace({u.x, u.y, v.x, v.y, offset.x, offset.y}, 0);
  if (!is_new) return known->second;
  const std::size_t count = mesh.vertices.size();
  const std::size_t view = binary_.addView(
      count * 8, GltfBinary::Target::vertices, 0, [&mesh, count, placing](const UseBytes& use) {
        return giveFloats<2>(count, use, [&](std::size_t i) {
          const glm::vec2 at = placing.of(mesh.vertices[i].texture);
          // Ours has v up, glTF has v down.
          return std::array<float, 2>{at.x, 1.0F - at.y};
        });
      });
  known->second = binary_.addAccessor(view, 0, kGltfFloat, "VEC2", count);
  return known->second;
}

Json GltfMeshes::describePrimitive(const Mesh& mesh, const Primitive& primitive,
                                   const Material& material) {
  const MeshPart& part = mesh.parts[primitive.part];
  Geometry& geometry = geometryOf(mesh);
  Json json;
  json["attributes"]["POSITION"] = geometry.positions;
  json["attributes"]["NORMAL"] = geometry.normals;
  if (materials_.hasImage(primitive.material)) {
    json["attributes"]["TEXCOORD_0"] = placesOf(mesh, geometry, material);
  }
  if (primitive.tinted) {
    addColors(mesh, geometry);
    json["attributes"]["COLOR_0"] = *geometry.colors;
  }
  const auto [known, is_new] = index_accessors_.try_emplace({&mesh, primitive.part}, 0);
  if (is_new) {
    known->second = binary_.addAccessor(geometry.indices, std::uint64_t{part.first_index} * 4,
                                        kGltfUint32, "SCALAR", part.index_count);
  }
  json["indices"] = known->second;
  json["material"] = primitive.material;
  return json;
}

std::optional<std::size_t> GltfMeshes::add(const PosedDevice& device, std::size_t link,
                                           const Visual& visual) {
  if (!visual.mesh) return std::nullopt;
  const Mesh& mesh = *visual.mesh;
  std::vector<Primitive> primitives;
  std::vector<Material> looks;
  const auto addPart = [&](std::size_t number) {
    if (number >= mesh.parts.size()) return;
    const MeshPart& part = mesh.parts[number];
    if (part.index_count == 0) return;
    // A link that is hidden now may be shown later; its parts are judged one by one.
    if (device.has_parts && device.link_visible[link] && !device.partVisible(link, part.group)) {
      return;
    }
    looks.push_back(materialOf(device, link, visual, part));
    Primitive primitive;
    primitive.part = number;
    primitive.material = materials_.add(looks.back());
    const bool is_recolored = device.has_parts ? device.partColor(link, part.group).has_value()
                                               : device.link_color[link].has_value();
    primitive.tinted = !mesh.colors.empty() && !visual.material && !is_recolored;
    triangles_ += part.index_count / 3;
    primitives.push_back(primitive);
  };
  if (visual.mesh_parts.empty()) {
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) addPart(i);
  }
  for (const std::size_t part : visual.mesh_parts) addPart(part);
  if (primitives.empty()) return std::nullopt;
  const auto [known, is_new] = known_.try_emplace({&mesh, primitives}, meshes_.size());
  if (!is_new) return known->second;
  Json made;
  made["primitives"] = Json::array();
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    made["primitives"].push_back(describePrimitive(mesh, primitives[i], looks[i]));
  }
  meshes_.push_back(std::move(made));
  return known->second;
}

void GltfMeshes::describe(Json& document) const {
  if (!meshes_.empty()) document["meshes"] = meshes_;
}

}  // namespace rocinante
