#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/report/json_text.h"
#include "recorder/gltf/gltf_materials.h"

namespace rocinante {

/// Meshes of a glTF document: the vertices of a Mesh are in the file once, however many visuals and
/// materials use them. Borrows the meshes until the document is written.
class GltfMeshes {
 public:
  GltfMeshes(GltfBinary& binary, GltfMaterials& materials)
      : binary_(binary), materials_(materials) {}

  /// A visual of a link, coloured as `device` is, without the parts that it hides. Answers the
  /// mesh's number; empty when nothing is drawn.
  std::optional<std::size_t> add(const PosedDevice& device, std::size_t link, const Visual& visual);

  void describe(Json& document) const;
  std::size_t count() const { return meshes_.size(); }
  std::uint64_t triangles() const { return triangles_; }  ///< of all visuals that were added

 private:
  /// Scale, turn and offset of a map, baked into texture coordinates.
  using MapPlace = std::tuple<float, float, float, float, float, float>;
  struct Geometry {
    std::size_t positions = 0, normals = 0;  ///< accessors
    std::size_t indices = 0;                 ///< a bufferView
    std::optional<std::size_t> colors;       ///< accessor
    std::map<MapPlace, std::size_t> places;  ///< accessors of texture coordinates
  };
  struct Primitive {
    std::size_t part = 0, material = 0;
    bool tinted = false;
    auto operator<=>(const Primitive&) const = default;
  };

  Geometry& geometryOf(const Mesh& mesh);
  void addColors(const Mesh& mesh, Geometry& geometry);
  std::size_t placesOf(const Mesh& mesh, Geometry& geometry, const Material& material);
  Json describePrimitive(const Mesh& mesh, const Primitive& primitive, const Material& material);

  GltfBinary& binary_;
  GltfMaterials& materials_;
  std::map<const Mesh*, Geometry> geometry_;
  std::map<std::pair<const Mesh*, std::vector<Primitive>>, std::size_t> known_;
  std::map<std::pair<const Mesh*, std::size_t>, std::size_t> index_accessors_;
  Json meshes_ = Json::array();
  std::uint64_t triangles_ = 0;
};

}  // namespace rocinante
