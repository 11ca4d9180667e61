#pragma once

#include <memory>

#include "core/model/cell.h"
#include "viewer/render/camera.h"
#include "viewer/render/draw_list.h"
#include "viewer/render/mesh_buffers.h"
#include "viewer/render/overlay.h"
#include "viewer/render/shader_program.h"
#include "viewer/render/texture_store.h"

namespace rocinante {

/// The draw stage: GL calls and nothing else. Every pass draws into whatever framebuffer is bound.
/// Call begin() before the first pass and end() after the last. Its context must be current.
class DrawPasses {
 public:
  static Result<std::unique_ptr<DrawPasses>> create(const GlTable& gl, const TextAtlas& atlas);
  ~DrawPasses();
  DrawPasses(const DrawPasses&) = delete;
  DrawPasses& operator=(const DrawPasses&) = delete;

  /// What a Camera must be made with for these passes.
  ClipDepth clipDepth() const {
    return gl_.ClipControl != nullptr ? ClipDepth::zero_to_one : ClipDepth::minus_one_to_one;
  }

  void begin() const;
  void drawBackground(const CellScene& look) const;
  void drawOpaque(const DrawList& list, const SceneCatalog& catalog, const MeshBuffers& meshes,
                  const TextureStore& textures, const Camera& camera, const CellScene& look) const;
  void drawGrid(const Camera& camera, const CellScene& look) const;
  /// Depth-tested, in the scene.
  void drawInScene(const Overlay& overlay) const;
  void drawTranslucent(const DrawList& list, const SceneCatalog& catalog, const MeshBuffers& meshes,
                       const TextureStore& textures, const Camera& camera,
                       const CellScene& look) const;
  /// Over everything.
  void drawOnTop(const Overlay& overlay) const;
  /// Leaves GL's state as a guest expects it: no depth test, no blending, nothing bound.
  void end() const;

 private:
  struct SceneUniforms {
    GLint clip_from_model, relative_from_model, normal_from_model, map_scale, map_offset;
    GLint diffuse, specular, emission, shininess, has_map, has_tint;
    GLint orthographic, view_direction, key_direction, fill_direction;
  };
  DrawPasses(const GlTable& gl, ShaderProgram scene, ShaderProgram background, ShaderProgram grid,
             ShaderProgram overlay, const TextAtlas& atlas);
  void setScene(const Camera& camera, const CellScene& look) const;
  void setItem(const DrawItem& item, const TextureStore& textures, const Camera& camera) const;
  void drawItem(const DrawItem& item, const SceneCatalog& catalog) const;
  void drawVertices(const Overlay& overlay) const;

  const GlTable& gl_;
  ShaderProgram scene_, background_, grid_, overlay_;
  SceneUniforms uniforms_{};
  GLuint empty_array_ = 0, grid_array_ = 0, grid_vertices_ = 0;
  GLuint overlay_array_ = 0, overlay_vertices_ = 0, atlas_texture_ = 0;
};

}  // namespace rocinante
