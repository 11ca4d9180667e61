#pragma once

#include <cstdint>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/cull/scene_catalog.h"
#include "viewer/detail/detail_level.h"
#include "viewer/view/camera.h"
#include "viewer/view/link_looks.h"
#include "viewer/view/movable_devices.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// Bounding sphere of a part in world space.
struct PartSphere {
  Vec3 center{};
  double radius_m = 0;
  double scale = 1;  ///< largest scale factor of the mesh
};

/// Whether the level leaves the part out: its sphere is smaller than cull_below_px across.
bool tooSmall(const PartSphere& sphere, const Camera& camera, const DetailLevel& level);

/// The coarsest version of the part with an error of at most geometry_error_px at its point nearest
/// to the eye; null: the part itself. Pure: depends only on camera and level.
const CoarsePart* coarseVersion(const CatalogPart& part, const PartSphere& sphere,
                                const Camera& camera, const DetailLevel& level);

/// One part of one mesh, drawn once.
struct DrawItem {
  std::uint32_t mesh = 0;     ///< into SceneCatalog::meshes
  std::uint32_t part = 0;     ///< of that mesh
  std::uint32_t device = 0;   ///< into PosedScene::devices
  std::uint32_t link = 0;     ///< of its model
  bool tinted = false;        ///< by its vertex colours (Mesh::colors)
  std::int32_t texture = -1;  ///< into SceneCatalog::textures; -1: none
  std::uint32_t coplanar_rank = 0;
  float lift_units = 0;                ///< of depth, added to the rank (liftCoplanarItems)
  const CoarsePart* coarse = nullptr;  ///< drawn instead of the part; null: the part
  const Material* material = nullptr;
  /// Drawn whole where the texture's alpha is at least `cutoff`, else not at all (AlphaMode::mask).
  bool is_cut = false;
  float cutoff = 0;
  glm::vec4 diffuse{};    ///< display values and opacity, with overrides
  Mat4 world{1.0};        ///< of the mesh's vertices
  double distance = 0;    ///< from the eye to the part's centre
  bool mirrored = false;  ///< `world` flips the winding of triangles
  bool translucent = false;
  bool outlined = false;  ///< RenderStyle::outlined
  bool batched = false;   ///< may be drawn in a batch (ItemBatch)
};

/// Whether two items without textures look the same, apart from their place.
bool sameLook(const DrawItem& a, const DrawItem& b);

/// The geometry of one frame in drawing order.
struct DrawList {
  /// Sorted by state, so that little changes between draws; batched items come last, by look and
  /// then in scene order, so that neighbours are drawn together.
  std::vector<DrawItem> opaque;
  std::vector<DrawItem> translucent;  ///< from back to front
  std::vector<DrawItem> wireframe;    ///< drawn only as lines
  std::vector<DrawItem> ghosts;       ///< GhostStyle::clear
  std::uint64_t triangles = 0;
  std::vector<DrawItem> spare;  ///< memory reused by sorting

  /// Empties the lists and keeps their memory.
  void clear();
};

/// How invisible parts are found; the list is the same.
enum class Culling {
  by_device,  ///< device, then link, then part: an invisible device costs one test
  by_part,    ///< every part separately
};

/// The cull stage. `translucent_textures`: by texture number, non-zero for pictures that are not
/// fully opaque. Pure: the same scene, camera and detail give the same list. The catalog must be of
/// the same geometry.
DrawList makeDrawList(const PosedScene& scene, const SceneCatalog& catalog,
                      const ViewChoice& choice, const Camera& camera,
                      const std::vector<std::uint8_t>& translucent_textures,
                      const LinkLooks& looks = {}, DrawnGeometry geometry = DrawnGeometry::visuals,
                      const DetailLevel& detail = {}, Culling culling = Culling::by_device);

/// The same, replacing the content of `list` and reusing its memory.
void makeDrawList(DrawList& list, const PosedScene& scene, const SceneCatalog& catalog,
                  const ViewChoice& choice, const Camera& camera,
                  const std::vector<std::uint8_t>& translucent_textures,
                  const LinkLooks& looks = {}, DrawnGeometry geometry = DrawnGeometry::visuals,
                  const DetailLevel& detail = {}, Culling culling = Culling::by_device);

/// Corners of the bounding boxes of everything visible, in world space, for fitted views.
/// `devices`: only these; null: all.
std::vector<Vec3> visibleCorners(const PosedScene& scene, const SceneCatalog& catalog,
                                 const ViewChoice& choice, const DeviceNames* devices = nullptr);

/// Sorts from back to front by DrawItem::distance; a box that contains others comes after them
/// while the eye is outside: a glass cabin after the robot in it. Stable. Containment is not tested
/// among more than two thousand items.
void sortFromBackToFront(std::vector<DrawItem>& items, const SceneCatalog& catalog,
                         const Camera& camera);

}  // namespace rocinante
