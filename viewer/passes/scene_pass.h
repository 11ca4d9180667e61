#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "core/cell/cell.h"
#include "viewer/cull/draw_list.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/contact_map.h"
#include "viewer/passes/item_batch.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/passes/shadow_map.h"
#include "viewer/passes/texture_store.h"
#include "viewer/view/camera.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// How surfaces are drawn; the default is the shader without any look.
struct SurfaceLook {
  Shading shading = Shading::standard;
  const ShadowLookup* shadows = nullptr;   ///< of the standard shading; null: none
  const ContactLookup* contact = nullptr;  ///< the same
  float depth_ranks = 0;                   ///< lift of all surfaces (setDepthLift)
  bool depth_only = false;                 ///< surfaces write only depth
  bool holes = false;                      ///< some picture has transparent pixels
  bool cutouts = false;                    ///< some material cuts holes (AlphaMode::mask)
};

/// Draws the geometry of a draw list into the bound framebuffer, between DrawPasses::begin() and
/// end(). Sets only state that changes between items. Its context must be current whenever it is
/// used or destroyed.
class ScenePass {
 public:
  /// Begins the programs of plain shading, which a page's first picture has.
  explicit ScenePass(const GlTable& gl);

  /// Compiles the programs for these surfaces and the lights of `look`, on first use. Before they
  /// are drawn.
  Status prepare(const SurfaceLook& surfaces, const CellScene& look);
  void drawOpaque(const DrawList& list, const SceneCatalog& catalog, const MeshBuffers& meshes,
                  const TextureStore& textures, const Camera& camera, const CellScene& look,
                  const SurfaceLook& surfaces = {}) const;
  /// Items of DrawList::translucent, from back to front.
  void drawTranslucent(std::span<const DrawItem> items, const SceneCatalog& catalog,
                       const MeshBuffers& meshes, const TextureStore& textures,
                       const Camera& camera, const CellScene& look,
                       const SurfaceLook& surfaces = {}) const;

 private:
  struct Program {
    ShaderProgram shader;
    GLint clip_from_model = -1, relative_from_model = -1, normal_from_model = -1, map_along = -1;
    GLint map_offset = -1, diffuse = -1, specular = -1, emission = -1;
    GLint shininess = -1, has_map = -1, has_tint = -1, cutoff = -1, orthographic = -1;
    GLint view_direction = -1, key_direction = -1, fill_direction = -1;
  };
  /// The standard shading with shadows and contact, and with a number of lights of the cell.
  struct Variant {
    bool shadows = false;
    bool contact = false;
    std::size_t lights = 0;
    bool cutout = false;
    auto operator<=>(const Variant&) const = default;
  };
  static Variant variantOf(const SurfaceLook& surfaces, const CellScene& look);
  /// Requires prepare().
  const Program* standardIn(const Variant& variant) const;
  class Items;  // one run of items: caches GL's state
  static Status finish(ShaderProgram begun, std::optional<Program>& program);
  ShaderProgram begin(std::string_view name, std::string_view vertex,
                      std::string_view fragment) const;
  Status preparePlain();
  Status prepareStandard();
  Status prepareHoles();
  Status preparePlainCutout();
  Status prepareVariant(const Variant& variant);

  const GlTable& gl_;
  /// Of plain shading, until it is prepared.
  struct Begun {
    ShaderProgram plain, mapped, batched;
  };
  std::optional<Begun> begun_;
  // Empty until they are prepared.
  std::optional<Program> standard_, plain_, plain_mapped_, plain_cutout_;
  std::optional<Program> holes_;                        // depth only, for pictures with holes
  std::optional<Program> batched_, batched_plain_;      // of standard and plain, for batch_
  mutable ItemBatch batch_;                             // memory reused by every frame
  std::map<Variant, std::optional<Program>> variants_;  // of standard; see prepare()
};

}  // namespace rocinante
