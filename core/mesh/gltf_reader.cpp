#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/json_read.h"
#include "core/mesh/gltf_document.h"
#include "core/mesh/gltf_materials.h"
#include "core/mesh/gltf_placing.h"
#include "core/mesh/gltf_primitive.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/mtl_reader.h"
#include "core/mesh/polygon.h"

namespace rocinante {
namespace {

/// y up to z up: x stays right.
const Mat4 kZUp(Vec4(1, 0, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, 0, 1));

class GltfReader {
 public:
  GltfReader(const GltfDocument& document, const std::filesystem::path& path,
             const ResolveFile& resolve, const MeshReadOptions& options, FaultList& faults)
      : document_(document), path_(path), resolve_(resolve), options_(options), faults_(faults) {}

  Result<Mesh> read() {
    loose_.materials = GltfMaterialReader(document_, path_, resolve_, faults_).readAll();
    findPlaces();
    if (Status added = addScene(); !added.ok()) return added.error();
    nameWhatGltfLeavesOut(document_, is_drawn_, faults_);
    if (loose_.corners.empty()) {
      return Error{ErrorKind::damaged, "holds no triangle that can be drawn", path_.string()};
    }
    if (loose_.materials.empty()) loose_.materials.push_back(GltfMaterialReader::plain());
    smoothNormals(loose_, options_.smooth_angle_deg);
    return indexedMesh(std::move(loose_));
  }

 private:
  struct Primitive {
    const GltfJson* json;
    GltfTriangles triangles;
  };

  /// Where every node is, and its nearest name; parents before their children, without recursion.
  void findPlaces() {
    const GltfJson& nodes = document_.all("nodes");
    places_.assign(nodes.size(), kZUp);
    groups_.assign(nodes.size(), "");
    is_drawn_.assign(nodes.size(), false);
    std::vector<bool> has_parent(nodes.size(), false);
    const auto eachChild = [&](std::size_t node, const auto& each) {
      const auto children = nodes[node].find("children");
      if (children == nodes[node].end()) return;
      for (const GltfJson& child : *children) each(child.get<std::size_t>());
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      eachChild(i, [&](std::size_t child) { has_parent[child] = true; });
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!has_parent[i]) open.push_back(i);
    }
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      places_[node] = places_[node] * matrixOfGltfNode(nodes[node]);
      if (std::string name = textIn(nodes[node], "name"); !name.empty())
        groups_[node] = std::move(name);
      eachChild(node, [&](std::size_t child) {
        places_[child] = places_[node];
        groups_[child] = groups_[node];
        open.push_back(child);
      });
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!has_parent[i]) roots_.push_back(i);
    }
  }

  /// The nodes of the scene that is drawn, depth first, in the order of the file.
  Status addScene() {
    const GltfJson& scenes = document_.all("scenes");
    std::vector<std::size_t> open;
    if (scenes.empty()) {
      open = roots_;
    } else {
      const GltfJson& scene = scenes[gltfIndex(document_.root, "scene").value_or(0)];
      if (scene.contains("nodes")) open = scene["nodes"].get<std::vector<std::size_t>>();
    }
    std::ranges::reverse(open);
    const GltfJson& nodes = document_.all("nodes");
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      if (is_drawn_[node]) continue;
      is_drawn_[node] = true;
      if (Status added = addNode(node); !added.ok()) return added;
      const auto children = nodes[node].find("children");
      if (children == nodes[node].end()) continue;
      for (std::size_t i = children->size(); i-- > 0;) {
        open.push_back((*children)[i].get<std::size_t>());
      }
    }
    return {};
  }

  Status addNode(std::size_t number) {
    const GltfJson& node = document_.all("nodes")[number];
    const auto mesh = gltfIndex(node, "mesh");
    if (!mesh) return {};
    const std::vector<Primitive>& primitives = primitivesOf(*mesh);
    if (primitives.empty()) return {};
    if (const auto skin = gltfIndex(node, "skin")) {
      const auto [joints, is_new] = joints_.try_emplace(*skin);
      if (is_new) joints->second = gltfJoints(document_, document_.all("skins")[*skin], places_);
      return addMesh(*mesh, primitives, GltfPlacing(places_[number]), &joints->second,
                     groups_[number]);
    }
    const GltfJson* const instances = gltfExtension(node, "EXT_mesh_gpu_instancing");
    if (instances == nullptr) {
      return addMesh(*mesh, primitives, GltfPlacing(places_[number]), nullptr, groups_[number]);
    }
    return addInstances((*instances)["attributes"], number, *mesh, primitives);
  }

  Status addInstances(const GltfJson& attributes, std::size_t node, std::size_t mesh,
                      const std::vector<Primitive>& primitives) {
    std::optional<GltfAccessor> given[3];
    std::size_t count = 0;
    const char* const keys[] = {"TRANSLATION", "ROTATION", "SCALE"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (const auto accessor = gltfIndex(attributes, keys[k])) {
        count = given[k].emplace(document_, *accessor).count();
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> at{0, 0, 0}, scale{1, 1, 1};
      std::array<double, 4> turn{0, 0, 0, 1};
      for (std::size_t axis = 0; axis < 4; ++axis) {
        if (given[1]) turn[axis] = given[1]->number(i, axis);
        if (axis == 3) break;
        if (given[0]) at[axis] = given[0]->number(i, axis);
        if (given[2]) scale[axis] = given[2]->number(i, axis);
      }
      Status added =
          addMesh(mesh, primitives, GltfPlacing(places_[node] * gltfPlacedBy(at, turn, scale)),
                  nullptr, groups_[node]);
      if (!added.ok()) return added;
    }
    return {};
  }

  /// Of its primitives those with triangles; kept, since many nodes may show one mesh.
  const std::vector<Primitive>& primitivesOf(std::size_t mesh) {
    const auto [known, is_new] = primitives_.try_emplace(mesh);
    if (!is_new) return known->second;
    const std::string place = fmt::format("meshes[{}]", mesh);
    for (const GltfJson& primitive : document_.all("meshes")[mesh]["primitives"]) {
      Primitive made{&primitive, gltfTriangles(document_, primitive)};
      if (made.triangles.outside > 0) {
        faults_.error("mesh.bad-triangle", {},
                      fmt::format("{}: {} triangles name vertices that the file does not have",
                                  place, made.triangles.outside),
                      "they are left out");
      }
      if (made.triangles.left_over > 0) {
        faults_.leaveOut("corner", "", {}, place + ": they make no whole triangle");
      }
      if (!made.triangles.corners.empty()) known->second.push_back(std::move(made));
    }
    return known->second;
  }

  Status addMesh(std::size_t mesh, const std::vector<Primitive>& primitives,
                 const GltfPlacing& placing, const std::vector<Mat4>* joints,
                 const std::string& group) {
    for (const Primitive& primitive : primitives) {
      tried_ += primitive.triangles.corners.size();
      if (tried_ > kMaxSceneTriangles * 3 ||
          loose_.positions.size() + primitive.triangles.vertices.size() > kMaxSceneTriangles * 3) {
        return Error{ErrorKind::unsupported,
                     fmt::format("has more than {} triangles", kMaxSceneTriangles), path_.string()};
      }
      addPrimitive(mesh, primitive, placing, joints, group);
    }
    return {};
  }

  void addPrimitive(std::size_t mesh, const Primitive& primitive, const GltfPlacing& placing,
                    const std::vector<Mat4>* joints, const std::string& group) {
    const GltfJson& json = *primitive.json;
    const auto base = static_cast<std::uint32_t>(loose_.positions.size());
    const auto first_texture = static_cast<std::uint32_t>(loose_.textures.size());
    const auto first_normal = static_cast<std::uint32_t>(loose_.normals.size());
    const GltfAccessor positions = *gltfAttribute(document_, json, "POSITION");
    const auto normals = gltfAttribute(document_, json, "NORMAL");
    const auto textures = gltfAttribute(document_, json, gltfTextureAttribute(document_, json));
    const auto colors = gltfAttribute(document_, json, "COLOR_0");
    const GltfSkinning skinning = gltfSkinning(document_, json, joints);
    const std::uint32_t material = materialOf(json);
    if (colors) has_colors_ = true;
    if (has_colors_) loose_.colors.resize(base, 0xFFFFFFFF);
    bool has_opacity = false;

    for (const std::uint32_t i : primitive.triangles.vertices) {
      const std::optional<GltfPlacing> skinned =
          skinning.sets.empty() ? std::nullopt : skinning.of(i);
      const GltfPlacing& place = skinned ? *skinned : placing;
      const auto point = [&](const GltfAccessor& of) {
        return Vec3(static_cast<double>(of.single(i, 0)), static_cast<double>(of.single(i, 1)),
                    static_cast<double>(of.single(i, 2)));
      };
      loose_.positions.emplace_back(glm::vec3(place.to_root * Vec4(point(positions), 1.0)));
      if (textures) {
        const float u = textures->single(i, 0), v = textures->single(i, 1);
        const bool sound = std::isfinite(u) && std::isfinite(v);
        loose_.textures.emplace_back(sound ? glm::vec2(u, 1.0F - v) : glm::vec2(0.0F));
      }
      if (normals) {
        const Vec3 turned = place.normal_turn * point(*normals);
        const double length = std::sqrt(glm::dot(turned, turned));
        const bool sound = length > 1e-30 && std::isfinite(length);
        loose_.normals.emplace_back(sound ? glm::vec3(turned / length) : glm::vec3(NAN));
      }
      if (!has_colors_) continue;
      glm::vec4 color(1.0F);
      for (std::size_t c = 0; colors && c < 3; ++c) {
        color[static_cast<int>(c)] = gltfShown(colors->number(i, c));
      }
      if (colors && colors->components() == 4) color.a = colors->single(i, 3);
      has_opacity = has_opacity || color.a < 1.0F;
      loose_.colors.push_back(packedColor(color));
    }
    if (has_opacity && loose_.materials[material].alpha_mode != AlphaMode::opaque) {
      faults_.leaveOut("attribute", "COLOR_0 opacity", {},
                       fmt::format("meshes[{}]: the opacity of vertex colours is not drawn", mesh),
                       Severity::warning);
    }
    addCorners(mesh, primitive.triangles,
               {base, textures ? first_texture : kNone, normals ? first_normal : kNone},
               placing.volume < 0 && skinning.sets.empty(), {group, material, 0, 0});
  }

  void addCorners(std::size_t mesh, const GltfTriangles& triangles, const Corner& first,
                  bool is_mirrored, MeshPart part) {
    part.first_index = static_cast<std::uint32_t>(loose_.corners.size());
    for (std::size_t i = 0; i < triangles.corners.size(); i += 3) {
      Corner corners[3];
      bool sound = true;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t vertex = triangles.corners[i + c];
        corners[c].position = first.position + vertex;
        sound = sound && isDrawablePoint(loose_.positions[corners[c].position]);
        if (first.texture != kNone) corners[c].texture = first.texture + vertex;
        if (first.normal == kNone) continue;
        const std::uint32_t normal = first.normal + vertex;
        if (!std::isnan(loose_.normals[normal].x)) corners[c].normal = normal;
      }
      if (!sound) {
        faults_.error("mesh.bad-triangle", {},
                      fmt::format("triangle {} of meshes[{}] has a corner beyond what can be drawn",
                                  i / 3, mesh),
                      "it is left out");
        continue;
      }
      if (is_mirrored) std::swap(corners[1], corners[2]);
      loose_.corners.insert(loose_.corners.end(), corners, corners + 3);
    }
    part.index_count = static_cast<std::uint32_t>(loose_.corners.size()) - part.first_index;
    if (part.index_count > 0) loose_.parts.push_back(std::move(part));
  }

  /// The material's number; the plain one is made when the first primitive needs it.
  std::uint32_t materialOf(const GltfJson& primitive) {
    if (const auto given = gltfIndex(primitive, "material")) {
      return static_cast<std::uint32_t>(*given);
    }
    if (!plain_) {
      plain_ = static_cast<std::uint32_t>(loose_.materials.size());
      loose_.materials.push_back(GltfMaterialReader::plain());
    }
    return *plain_;
  }

  const GltfDocument& document_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  LooseMesh loose_;
  bool has_colors_ = false;
  std::size_t tried_ = 0;  // corners
  std::optional<std::uint32_t> plain_;
  std::vector<std::size_t> roots_;
  std::vector<Mat4> places_;                                  // by node, to our axes
  std::vector<std::string> groups_;                           // by node
  std::vector<bool> is_drawn_;                                // by node
  std::map<std::size_t, std::vector<Primitive>> primitives_;  // by mesh
  std::map<std::size_t, std::vector<Mat4>> joints_;           // by skin
};

}  // namespace

Result<Mesh> readGltf(ByteView bytes, const std::filesystem::path& path,
                      const MeshReadOptions& options, FaultList& faults) {
  if (bytes.size() > kMaxSceneBytes) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the file is larger than the {} MiB that are read", kMaxSceneBytes >> 20),
        path.string()};
  }
  const ResolveFile resolve = resolverOf(options);
  const Result<GltfDocument> document = openGltf(bytes, path, resolve);
  if (!document.ok()) return document.error();
  return GltfReader(*document, path, resolve, options, faults).read();
}

}  // namespace rocinante
