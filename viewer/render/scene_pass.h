#pragma once

#include "core/model/cell.h"
#include "viewer/render/camera.h"
#include "viewer/render/draw_list.h"
#include "viewer/render/mesh_buffers.h"
#include "viewer/render/shader_program.h"
#include "viewer/render/texture_store.h"

namespace rocinante {

/// Draws the geometry of a draw list into whatever framebuffer is bound, between
/// DrawPasses::begin() and end(). Its context must be current whenever it is used or destroyed.
class ScenePass {
 public:
  static Result<ScenePass> create(const GlTable& gl);

  void drawOpaque(const DrawList& list, const SceneCatalog& catalog, const MeshBuffers& meshes,
                  const TextureStore& textures, const Camera& camera, const CellScene& look) const;
  void drawTranslucent(const DrawList& list, const SceneCatalog& catalog, const MeshBuffers& meshes,
                       const TextureStore& textures, const Camera& camera,
                       const CellScene& look) const;

 private:
  struct Uniforms {
    GLint clip_from_model, relative_from_model, normal_from_model, map_scale, map_offset;
    GLint diffuse, specular, emission, shininess, has_map, has_tint;
    GLint orthographic, view_direction, key_direction, fill_direction;
  };
  ScenePass(const GlTable& gl, ShaderProgram program);
  void setScene(const Camera& camera, const CellScene& look) const;
  void setItem(const DrawItem& item, const TextureStore& textures, const Camera& camera) const;

  const GlTable& gl_;
  ShaderProgram program_;
  Uniforms uniforms_{};
};

}  // namespace rocinante
