#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/gl/inputs_hash.h"
#include "viewer/passes/draw_passes.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/passes/identity_pass.h"
#include "viewer/passes/look_passes.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// The members of a Renderer, for renderer.cpp (frames), renderer_light.cpp (shadows and contact)
/// and renderer_numbers.cpp (identity and depth).
struct Renderer::Impl {
  static constexpr int kTextPixels = 16;

  Impl(const GlTable& table, const Cell& the_cell, Profile profile)
      : gl(table),
        key(rendererKey(gl)),
        passes(gl),
        cell(the_cell),
        catalog(cell),
        atlas(kTextPixels),
        meshes(gl, catalog, inputs),
        textures(gl, catalog.textures(), profile, inputs) {
    inputs.add(std::as_bytes(std::span(atlas.coverage())));
    inputs_text = inputs.text();
  }

  /// Collision geometry, uploaded on first use. Not in the inputs hash: a frame without it does not
  /// depend on it.
  struct CollisionGeometry {
    CollisionGeometry(const GlTable& gl, const Cell& cell)
        : catalog(cell, DrawnGeometry::collisions), meshes(gl, catalog, unused_inputs) {}
    SceneCatalog catalog;
    InputsHash unused_inputs;
    MeshBuffers meshes;
  };

  struct ViewLight {
    std::optional<ShadowLookup> shadows;
    std::optional<ContactLookup> contact;
  };

  GlTable gl;
  RendererKey key;
  DrawPasses passes;  // before what takes time: its programs are compiled meanwhile
  const Cell& cell;
  SceneCatalog catalog;
  TextAtlas atlas;
  InputsHash inputs;
  MeshBuffers meshes;
  TextureStore textures;
  std::optional<DetailBuilder> detail_builder;          // borrows the catalog
  std::optional<std::vector<DetailInput>> detail_left;  // of makeNextDetail(); the same
  std::vector<std::size_t> detail_order;                // its meshes, the next one last
  std::optional<CollisionGeometry> collision;           // made on first use
  mutable std::map<int, TextAtlas> other_atlases;       // of other scales than 1, by line in pixels
  DrawList view_list;  // of the current view; memory reused by frames
  LookPasses look_passes{gl};
  std::optional<IdentityPass> identity_pass;  // made on first use
  std::optional<FrameBuffer> pick_target;     // as large as the picture clicked on
  int whole_width = 1, whole_height = 1;      // of the picture that is being drawn
  std::uint64_t frames_drawn = 0;
  std::map<std::size_t, ViewLight> lights;  // of the views of the frame, by their numbers
  std::string inputs_text;

  const TextAtlas& atlasOf(double scale) const;
  Camera cameraOf(const SceneFrame& frame, const CameraView& view, int width, int height) const;
  DrawList listOf(const SceneFrame& frame, const Camera& camera, const LinkLooks& looks) const {
    return makeDrawList(*frame.scene, catalog, *frame.choice, camera, textures.translucent(), looks,
                        DrawnGeometry::visuals, frame.detail);
  }
  DrawList collisionListOf(const SceneFrame& frame, const Camera& camera,
                           const LinkLooks& looks) const {
    return makeDrawList(*frame.scene, collision->catalog, *frame.choice, camera, {}, looks,
                        DrawnGeometry::collisions);
  }
  /// Fills the two lists with the visible geometry of a view, coplanar surfaces lifted.
  std::vector<DrawnSet> setsOf(const SceneFrame& frame, const LinkLooks& looks,
                               const Camera& camera, DrawList& list, DrawList& collisions) const;
  /// The looks of the scene's links by the style. Makes `collision` if it is needed.
  Result<LinkLooks> looksOf(const SceneFrame& frame);
  /// unsupported when there are more than the limit of a frame.
  static Status checkTriangles(std::span<const DrawnSet> sets);
  /// Draws one view into a part of the bound framebuffer. `number`: 0 for the main view, from 1 on
  /// for insets.
  Result<DrawCounts> drawView(const SceneFrame& frame, const LinkLooks& looks,
                              const CameraView& view, std::size_t number,
                              const PixelRectangle& part, int frame_height);
  /// What keeps light from the surfaces of a view, drawn unless `lights` has it
  /// (renderer_light.cpp).
  Result<ViewLight> drawLight(const SceneFrame& frame, const LinkLooks& looks, const Camera& camera,
                              std::size_t number, std::span<const DrawnSet> sets,
                              const glm::vec2& origin);
  Result<ShadowLookup> drawShadows(const SceneFrame& frame, const LinkLooks& looks,
                                   const Camera& camera);
  /// A calibrated view's backdrop, if it shall have it: whole behind the scene, or over it.
  Status drawBackdrop(const SceneFrame& frame, const CameraView& view, std::size_t number,
                      const Camera& camera, double opacity);
  Status drawEdges(std::span<const DrawnSet> sets, const SceneFrame& frame, const Camera& camera);
  Overlay onTopOf(const SceneFrame& frame, const Camera& camera, const CameraView& view) const;
  void drawInsetFrames(const SceneFrame& frame, const FrameBuffer& target) const;
  Status prepareIdentity(const FrameBuffer& target);
  /// Draws the numbers of the geometry shown by drawView(), into a part begun by identity_pass.
  Status drawNumbers(const SceneFrame& frame, const LinkLooks& looks, const Camera& camera,
                     const std::function<std::uint32_t(const DrawItem&)>& number_of);
  Status glStatus() const;
};

/// Clamps depth for orthographic views: lines and grid beyond the depth range stay in front of or
/// behind everything else.
inline void setClamp(const GlTable& gl, bool clamp) {
  if (!gl.clamps_depth) return;
  clamp ? gl.Enable(GL_DEPTH_CLAMP) : gl.Disable(GL_DEPTH_CLAMP);
}

inline const RenderStyle& styleOf(const SceneFrame& frame) {
  static const RenderStyle kDefault;
  return frame.style != nullptr ? *frame.style : kDefault;
}

}  // namespace rocinante
