#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/cull/cull_sphere.h"
#include "viewer/cull/flat_faces.h"
#include "viewer/detail/mesh_detail.h"
#include "viewer/view/link_looks.h"

namespace rocinante {

/// Drawing data of one part of a mesh, apart from its triangles.
struct CatalogPart {
  Vec3 center{};  ///< of its bounds, in mesh space
  Vec3 half{};    ///< half their size
  double radius = 0;
  std::uint32_t coplanar_rank = 0;  ///< see CoplanarSurfaces
  PartFaces faces;
  /// Number of indices at the part's end that belong to one-sided triangles.
  std::uint32_t one_sided_count = 0;
  /// From fine to coarse; their indices follow the mesh's own (MeshBuffers::setDetail). Empty until
  /// SceneCatalog::setDetail().
  std::vector<CoarsePart> coarser;
};

struct CatalogMesh {
  const Mesh* mesh = nullptr;
  std::vector<CatalogPart> parts;
  /// The mesh's indices with each part's one-sided triangles last; empty when unchanged.
  std::vector<std::uint32_t> reordered;

  /// Whether its vertices are so few that a CPU transform costs less than a draw call (ItemBatch).
  bool isSmall() const {
    constexpr std::size_t kFewVertices = 32;  // a box has 24
    return mesh->vertices.size() <= kFewVertices && mesh->parts.size() == 1 && mesh->colors.empty();
  }

  const std::vector<std::uint32_t>& indices() const {
    return reordered.empty() ? mesh->indices : reordered;
  }
};

/// A picture from `at_hand` or `bytes` if not empty, `file` then being only a name; else from a
/// file.
struct CatalogTexture {
  std::filesystem::path file;
  std::shared_ptr<const Bytes> bytes;
  ByteView at_hand{};          ///< of Cell::pictures
  bool ignores_alpha = false;  ///< of materials with AlphaMode::opaque
  TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
};

/// Every mesh and texture of a cell's models, numbered. Numbers depend only on the cell (models by
/// name, then those of devices with their own appearance, links and visuals in file order), so that
/// the drawing order does not depend on earlier frames. Borrows the cell's meshes.
class SceneCatalog {
 public:
  explicit SceneCatalog(const Cell& cell, DrawnGeometry geometry = DrawnGeometry::visuals);

  const std::vector<CatalogMesh>& meshes() const { return meshes_; }
  const std::vector<CatalogTexture>& textures() const { return textures_; }
  std::optional<std::uint32_t> meshNumber(const Mesh* mesh) const;
  /// By mesh number: the input of coarser versions. Borrows from this catalog.
  std::vector<DetailInput> detailInputs() const;
  /// Coarser versions of a mesh's parts, made from its detailInputs().
  void setDetail(std::size_t mesh_number, const MeshDetail& detail);
  /// The reaches of a model's links; null for a model that is not in the cell.
  const LinkReaches* reaches(const Model& model) const;
  /// Empty for a material without a texture. One picture has a number for each way in which
  /// materials use it.
  std::optional<std::uint32_t> textureNumber(const Material& material) const;
  /// Whether a material cuts holes by a texture (AlphaMode::mask).
  bool hasCutouts() const { return has_cutouts_; }

 private:
  void addModel(const Model& model, DrawnGeometry geometry);
  void addTexture(const Material& material);
  void addMesh(const Mesh* mesh, const std::vector<std::uint32_t>& bodies);

  std::vector<CatalogMesh> meshes_;
  std::map<const Mesh*, std::uint32_t> mesh_numbers_;  // lookup only, never iterated
  std::vector<CatalogTexture> textures_;
  /// File, ignores_alpha, wrap_u, wrap_v.
  using TextureUse = std::tuple<std::filesystem::path, bool, TextureWrap, TextureWrap>;
  static TextureUse useOf(const Material& material);
  std::map<TextureUse, std::uint32_t> texture_numbers_;
  bool has_cutouts_ = false;
  std::map<const Model*, LinkReaches> reaches_;  // lookup only, never iterated
  const std::map<std::filesystem::path, ByteView>* at_hand_ = nullptr;  // while it is made
};

}  // namespace rocinante
