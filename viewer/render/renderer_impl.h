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

/// What a Renderer is made of, for renderer.cpp (frames) and renderer_numbers.cpp (identity and
/// depth).
struct Renderer::Impl {
  static constexpr int kTextPixels = 16;

  Impl(const GlTable& table, const Cell& the_cell, Profile profile)
      : gl(table),
        key(rendererKey(gl)),
        cell(the_cell),
        catalog(cell),
        atlas(kTextPixels),
        meshes(gl, catalog, inputs),
        textures(gl, catalog.textures(), profile, inputs) {
    inputs.add(std::as_bytes(std::span(atlas.coverage())));
    inputs_text = inputs.text();
  }

  /// Collision geometry, uploaded when it is first asked for. No part of the inputs hash: a frame
  /// without it does not depend on it.
  struct CollisionGeometry {
    CollisionGeometry(const GlTable& gl, const Cell& cell)
        : catalog(cell, DrawnGeometry::collisions), meshes(gl, catalog, unused_inputs) {}
    SceneCatalog catalog;
    InputsHash unused_inputs;
    MeshBuffers meshes;
  };

  GlTable gl;
  RendererKey key;
  const Cell& cell;
  SceneCatalog catalog;
  TextAtlas atlas;
  InputsHash inputs;
  MeshBuffers meshes;
  TextureStore textures;
  std::optional<DrawPasses> passes;
  std::optional<DetailBuilder> detail_builder;     // borrows the catalog
  std::optional<CollisionGeometry> collision;      // made when it is first asked for
  mutable std::map<int, TextAtlas> other_atlases;  // of other scales than 1, by line in pixels
  DrawList view_list;  // of the view at hand: memory that frames use again
  LookPasses look_passes{gl};
  std::optional<IdentityPass> identity_pass;  // made when it is first asked for
  std::optional<FrameBuffer> pick_target;     // as large as the picture clicked on
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
  /// All that a view shows of the geometry, in these two lists, coplanar surfaces lifted.
  std::vector<DrawnSet> setsOf(const SceneFrame& frame, const LinkLooks& looks,
                               const Camera& camera, DrawList& list, DrawList& collisions) const;
  /// What the style says of the scene's links; then `collision` is there where it is needed.
  Result<LinkLooks> looksOf(const SceneFrame& frame);
  /// unsupported when they are more than a frame may have.
  static Status checkTriangles(std::span<const DrawnSet> sets);
  /// One view into a part of what is bound.
  Result<DrawCounts> drawView(const SceneFrame& frame, const LinkLooks& looks,
                              const CameraView& view, const PixelRectangle& part, int frame_height);
  Result<ShadowLookup> drawShadows(const SceneFrame& frame, const LinkLooks& looks,
                                   const Camera& camera);
  Status drawEdges(std::span<const DrawnSet> sets, const SceneFrame& frame, const Camera& camera);
  Overlay onTopOf(const SceneFrame& frame, const Camera& camera, const CameraView& view) const;
  void drawInsetFrames(const SceneFrame& frame, const FrameBuffer& target) const;
  Status prepareIdentity(const FrameBuffer& target);
  /// Numbers of what drawView() shows of the geometry, into a part that identity_pass began.
  Status drawNumbers(const SceneFrame& frame, const LinkLooks& looks, const Camera& camera,
                     const std::function<std::uint32_t(const DrawItem&)>& number_of);
  Status glStatus() const;
};

/// Without perspective nothing is too near or too far: what lies past the reach of depths (lines,
/// the grid) is before or behind all else.
inline void setClamp(const GlTable& gl, bool clamp) {
  clamp ? gl.Enable(GL_DEPTH_CLAMP) : gl.Disable(GL_DEPTH_CLAMP);
}

inline const RenderStyle& styleOf(const SceneFrame& frame) {
  static const RenderStyle kDefault;
  return frame.style != nullptr ? *frame.style : kDefault;
}

}  // namespace rocinante
