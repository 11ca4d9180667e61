#pragma once

#include <span>

#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/caster_draw.h"
#include "viewer/passes/shadow_fit.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Data for a shader that reads a shadow map.
struct ShadowLookup {
  GLuint map = 0;                     ///< depth from the light; 1 is nearest
  glm::mat4 map_from_relative{1.0F};  ///< from world axes about the eye to [0, 1]
  float texel_m = 1;                  ///< what a texel covers
  bool operator==(const ShadowLookup&) const = default;
};

/// Binds a map at texture unit 1 for a program made with withShadows(), which must be in use.
void bindShadows(const GlTable& gl, const ShaderProgram& program, const ShadowLookup& shadows);

/// The depths seen by the key light, in our own 32-bit float texture, so that shadows are as
/// reproducible as the rest. Its context must be current whenever it is used or destroyed.
class ShadowMap {
 public:
  static constexpr int kSide = 2048;

  static Result<ShadowMap> create(const GlTable& gl);

  /// The camera for the list given to draw().
  Camera lightCamera(const ShadowFit& fit) const;

  /// Draws the mostly opaque items of `casters`. Restores the framebuffer binding, not the
  /// viewport.
  void draw(std::span<const DrawnSet> casters, const Camera& light) const;
  /// The map, for shaders relative to the eye of `camera`.
  ShadowLookup lookup(const Camera& light, const ShadowFit& fit, const Camera& camera) const;

 private:
  ShadowMap(const GlTable& gl, CasterDraw casters);

  const GlTable& gl_;
  CasterDraw casters_;
  GlFramebuffer frame_{gl_};
  GlTexture depth_{gl_};
};

}  // namespace rocinante
