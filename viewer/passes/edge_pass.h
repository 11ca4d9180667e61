#pragma once

#include <functional>
#include <map>
#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/mesh_edges.h"
#include "viewer/view/camera.h"

namespace rocinante {

enum class EdgeChoice {
  features,        ///< borders, creases, and outlines as seen from the camera
  features_alone,  ///< the same without surfaces: fades less with distance
  all,             ///< every edge of every triangle
};

/// Draws edges of meshes as depth-tested lines of constant pixel width into the bound framebuffer.
/// The edges of a mesh are found and uploaded on first use. Its context must be current whenever it
/// is used or destroyed.
class EdgePass {
 public:
  /// How far surfaces are moved back behind their lines (setDepthLift).
  static constexpr float kSurfaceRanks = -10;

  static Result<EdgePass> create(const GlTable& gl);

  using ColorOf = std::function<glm::vec4(const DrawItem&)>;

  /// Blended by the opacity of its colours; `scale` times the width.
  void draw(const std::vector<DrawItem>& items, const SceneCatalog& catalog, const Camera& camera,
            double scale, EdgeChoice choice, const ColorOf& color_of);

 private:
  struct Edges {
    GlTexture texture;
    std::vector<PartEdges> parts;
  };
  EdgePass(const GlTable& gl, ShaderProgram program);
  const Edges& edgesOf(const Mesh& mesh);
  void setItem(const DrawItem& item, const Camera& camera) const;

  const GlTable& gl_;
  ShaderProgram program_;
  GlVertexArray empty_array_{gl_};
  std::map<const Mesh*, Edges> edges_;  // lookup only
  struct Uniforms {
    GLint clip_from_model, eye, first_edge, every_edge, color, viewport, near, lift, low, unit_px,
        alone;
  } uniforms_{};
};

}  // namespace rocinante
