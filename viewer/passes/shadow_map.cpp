#include "viewer/passes/shadow_map.h"

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/math/transform.h"
#include "viewer/passes/look_shaders.h"

namespace rocinante {

void bindShadows(const GlTable& gl, const ShaderProgram& program, const ShadowLookup& shadows) {
  gl.UniformMatrix4fv(program.uniform("map_from_relative"), 1, GL_FALSE,
                      glm::value_ptr(shadows.map_from_relative));
  gl.Uniform1f(program.uniform("texel_m"), shadows.texel_m);
  gl.Uniform1i(program.uniform("shadow_map"), 1);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, shadows.map);
  gl.ActiveTexture(GL_TEXTURE0);
}

Result<ShadowMap> ShadowMap::create(const GlTable& gl) {
  auto drawn = CasterDraw::create(gl);
  if (!drawn) return drawn.error();
  ShadowMap map(gl, std::move(*drawn));
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  gl.BindTexture(GL_TEXTURE_2D, map.depth_);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, kSide, kSide, 0, GL_DEPTH_COMPONENT,
                GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, map.frame_);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.depth_, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  const bool complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  if (!complete) {
    return Error{ErrorKind::refused, "the GL driver cannot create a framebuffer for shadows", {}};
  }
  return map;
}

ShadowMap::ShadowMap(const GlTable& gl, CasterDraw casters)
    : gl_(gl), casters_(std::move(casters)) {}

Camera ShadowMap::lightCamera(const ShadowFit& fit) const {
  const ClipDepth depth =
      gl_.ClipControl != nullptr ? ClipDepth::zero_to_one : ClipDepth::minus_one_to_one;
  return Camera(fit.view, kSide, kSide, depth, fit.reach_m);
}

void ShadowMap::draw(std::span<const DrawnSet> casters, const Camera& light) const {
  GLint bound = 0;
  gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.Viewport(0, 0, kSide, kSide);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_GEQUAL);
  gl_.DepthMask(GL_TRUE);
  gl_.ClearDepth(0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  // Move away from the light by the slope across a texel and a half, the reach of the filter,
  // against self-shadowing. kSceneFragment's offset covers the rest.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(-1.5F, -8.0F);
  casters_.draw(casters, light);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

ShadowLookup ShadowMap::lookup(const Camera& light, const ShadowFit& fit,
                               const Camera& camera) const {
  // Clip space to [0, 1]; the light's depth already is, except for drivers without glClipControl.
  Mat4 unit(1.0);
  unit[0][0] = unit[1][1] = unit[3][0] = unit[3][1] = 0.5;
  if (gl_.ClipControl == nullptr) unit[2][2] = unit[3][2] = 0.5;
  const Mat4 map_from_relative =
      unit * light.clipFromRelative() * translationMatrix(camera.eye() - light.eye());
  return {depth_, glm::mat4(map_from_relative), static_cast<float>(fit.texel_m)};
}

}  // namespace rocinante
