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

/// One part of one mesh, drawn once.
struct DrawItem {
  std::uint32_t mesh = 0;     ///< into SceneCatalog::meshes
  std::uint32_t part = 0;     ///< of that mesh
  std::uint32_t device = 0;   ///< into PosedScene::devices
  std::uint32_t link = 0;     ///< of its model: with `device`, whose pixels these are
  bool tinted = false;        ///< by the colours at its points (Mesh::colors)
  std::int32_t texture = -1;  ///< into SceneCatalog::textures; -1: none
  std::uint32_t coplanar_rank = 0;
  float lift_units = 0;                ///< of depth, besides the rank's (liftCoplanarItems)
  const CoarsePart* coarse = nullptr;  ///< drawn in the part's place; null: the part itself
  const Material* material = nullptr;
  glm::vec4 diffuse{};    ///< display values and opacity, after colours that were set
  Mat4 world{1.0};        ///< of the mesh's vertices
  double distance = 0;    ///< from the eye to the middle of the part
  bool mirrored = false;  ///< `world` turns the front of triangles to their back
  bool translucent = false;
  bool outlined = false;  ///< RenderStyle::outlined
  bool batched = false;   ///< may be drawn as one with others like it (ItemBatch)
};

/// Whether two items without textures look the same, wherever they are.
bool sameLook(const DrawItem& a, const DrawItem& b);

/// What one frame draws of the geometry, in the order in which it is drawn.
struct DrawList {
  /// By state, so that few things change between draws; what is batched comes last, by look and
  /// then as the scene has it, so that what lies side by side is drawn after one another.
  std::vector<DrawItem> opaque;
  std::vector<DrawItem> translucent;  ///< from back to front
  std::vector<DrawItem> wireframe;    ///< drawn as lines alone
  std::vector<DrawItem> ghosts;       ///< GhostStyle::clear
  std::uint64_t triangles = 0;
  std::vector<DrawItem> spare;  ///< memory that sorting uses again

  /// Nothing is drawn; the memory stays.
  void clear();
};

/// How what cannot be seen is found; the list is the same.
enum class Culling {
  by_device,  ///< the device first, then the link, then the part: what is beside costs one test
  by_part,    ///< every part by itself
};

/// The cull stage. `translucent_textures`: by texture number, non-zero for pictures that are not
/// opaque everywhere. Pure: the same scene, camera and detail give the same list, whatever was
/// drawn before. The catalog must be of the same geometry.
DrawList makeDrawList(const PosedScene& scene, const SceneCatalog& catalog,
                      const ViewChoice& choice, const Camera& camera,
                      const std::vector<std::uint8_t>& translucent_textures,
                      const LinkLooks& looks = {}, DrawnGeometry geometry = DrawnGeometry::visuals,
                      const DetailLevel& detail = {}, Culling culling = Culling::by_device);

/// The same in place of what `list` held, in its memory.
void makeDrawList(DrawList& list, const PosedScene& scene, const SceneCatalog& catalog,
                  const ViewChoice& choice, const Camera& camera,
                  const std::vector<std::uint8_t>& translucent_textures,
                  const LinkLooks& looks = {}, DrawnGeometry geometry = DrawnGeometry::visuals,
                  const DetailLevel& detail = {}, Culling culling = Culling::by_device);

/// Corners of the boxes around everything visible, world space: what a fitted view must show.
/// `devices`: of these alone; null: of all.
std::vector<Vec3> visibleCorners(const PosedScene& scene, const SceneCatalog& catalog,
                                 const ViewChoice& choice, const DeviceNames* devices = nullptr);

}  // namespace rocinante
