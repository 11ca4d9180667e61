#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/cull/cull_sphere.h"
#include "viewer/cull/flat_faces.h"
#include "viewer/detail/mesh_detail.h"
#include "viewer/view/link_looks.h"

namespace rocinante {

/// What drawing needs to know of one part of a mesh, apart from its triangles.
struct CatalogPart {
  Vec3 center{};  ///< of its bounds, in the mesh
  Vec3 half{};    ///< half their size
  double radius = 0;
  std::uint32_t coplanar_rank = 0;  ///< see CoplanarSurfaces
  PartFaces faces;
  /// Of the part's indices, the last so many are triangles seen from their front alone.
  std::uint32_t one_sided_count = 0;
  /// From fine to coarse; their indices stand behind the mesh's own (MeshBuffers::setDetail).
  /// Empty until SceneCatalog::setDetail().
  std::vector<CoarsePart> coarser;
};

struct CatalogMesh {
  const Mesh* mesh = nullptr;
  std::vector<CatalogPart> parts;
  /// The mesh's indices with each part's one-sided triangles last; empty when that changes nothing.
  std::vector<std::uint32_t> reordered;

  /// Whether its vertices are so few that they are sooner moved than GL is told of them: ItemBatch.
  bool isSmall() const {
    constexpr std::size_t kFewVertices = 32;  // a box has 24
    return mesh->vertices.size() <= kFewVertices && mesh->parts.size() == 1 && mesh->colors.empty();
  }

  const std::vector<std::uint32_t>& indices() const {
    return reordered.empty() ? mesh->indices : reordered;
  }
};

/// A picture: a file's, or, when there are bytes, those; `file` is then a name for them.
struct CatalogTexture {
  std::filesystem::path file;
  std::shared_ptr<const Bytes> bytes;
};

/// Every mesh and texture of a cell's models, numbered. Numbers follow the cell alone (models by
/// name, then those of devices that look otherwise, links and visuals as their files have them), so
/// that the order in which things are drawn never depends on what was drawn before. Borrows the
/// cell's meshes.
class SceneCatalog {
 public:
  explicit SceneCatalog(const Cell& cell, DrawnGeometry geometry = DrawnGeometry::visuals);

  const std::vector<CatalogMesh>& meshes() const { return meshes_; }
  const std::vector<CatalogTexture>& textures() const { return textures_; }
  std::optional<std::uint32_t> meshNumber(const Mesh* mesh) const;
  /// By mesh number: what coarser versions are made of. Borrows from this catalog.
  std::vector<DetailInput> detailInputs() const;
  /// Coarser versions of a mesh's parts, made from its detailInputs().
  void setDetail(std::size_t mesh_number, const MeshDetail& detail);
  /// How far the geometry of a model's links reaches; null for a model that is not the cell's.
  const LinkReaches* reaches(const Model& model) const;
  /// Empty for a material without one.
  std::optional<std::uint32_t> textureNumber(const Material& material) const;

 private:
  void addModel(const Model& model, DrawnGeometry geometry);
  void addTexture(const Material& material);
  void addMesh(const Mesh* mesh, const std::vector<std::uint32_t>& bodies);

  std::vector<CatalogMesh> meshes_;
  std::map<const Mesh*, std::uint32_t> mesh_numbers_;  // looked up, never walked through
  std::vector<CatalogTexture> textures_;
  std::map<std::filesystem::path, std::uint32_t> texture_numbers_;
  std::map<const Model*, LinkReaches> reaches_;  // looked up, never walked through
};

}  // namespace rocinante
