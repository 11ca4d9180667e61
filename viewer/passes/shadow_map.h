#pragma once

#include <span>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/passes/shadow_fit.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// What a shader needs to ask a shadow map.
struct ShadowLookup {
  GLuint map = 0;                     ///< depth as the light sees it, 1 the nearest
  glm::mat4 map_from_relative{1.0F};  ///< from world axes about the eye to [0, 1]
  float texel_m = 1;                  ///< what a texel covers
  bool operator==(const ShadowLookup&) const = default;
};

/// Tells a program that was made withShadows() of a map, at texture unit 1; it must be in use.
void bindShadows(const GlTable& gl, const ShaderProgram& program, const ShadowLookup& shadows);

/// The depths that the key light sees: our own 32-bit float texture, so that shadows are the same
/// bits wherever the rest is. Its context must be current whenever it is used or destroyed.
class ShadowMap {
 public:
  static constexpr int kSide = 2048;

  static Result<ShadowMap> create(const GlTable& gl);
  ~ShadowMap();
  ShadowMap(ShadowMap&& other) noexcept;
  ShadowMap& operator=(ShadowMap&&) = delete;

  /// The camera that draw() needs a list for.
  Camera lightCamera(const ShadowFit& fit) const;

  /// Draws what is opaque, or nearly so, in `casters`; what was bound for drawing is bound again
  /// after, the viewport is not. The answer is for shaders that work about the eye of `camera`.
  ShadowLookup draw(std::span<const DrawnSet> casters, const Camera& light, const ShadowFit& fit,
                    const Camera& camera) const;

 private:
  ShadowMap(const GlTable& gl, ShaderProgram program);

  const GlTable& gl_;
  ShaderProgram program_;
  GLuint frame_ = 0, depth_ = 0;
};

}  // namespace rocinante
