#include "viewer/passes/contact_map.h"

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "viewer/passes/contact_shaders.h"
#include "viewer/passes/look_shaders.h"

namespace rocinante {
namespace {

/// Surroundings within this count. docs/rendering.md, section "Looks".
constexpr float kReach = 0.25F;

glm::vec4 depthTerms(const Camera& camera, bool zero_to_one) {
  const Mat4& clip = camera.clipFromRelative();
  const Vec4 at_eye = clip * Vec4(0, 0, 0, 1);
  const Vec3 forward = camera.forward();
  const Vec4 a_metre = clip * Vec4(forward.x, forward.y, forward.z, 0);
  const auto stored = [&](const Vec4& at) { return zero_to_one ? at.z : (at.z + at.w) / 2; };
  return {static_cast<float>(stored(at_eye)), static_cast<float>(stored(a_metre)),
          static_cast<float>(at_eye.w), static_cast<float>(a_metre.w)};
}

}  // namespace

void bindContact(const GlTable& gl, const ShaderProgram& program, const ContactLookup& contact) {
  gl.Uniform2f(program.uniform("contact_origin"), contact.origin.x, contact.origin.y);
  gl.Uniform2f(program.uniform("contact_scale"), contact.texels_a_pixel.x,
               contact.texels_a_pixel.y);
  gl.Uniform1i(program.uniform("contact_map"), 2);
  gl.ActiveTexture(GL_TEXTURE2);
  gl.BindTexture(GL_TEXTURE_2D, contact.map);
  gl.ActiveTexture(GL_TEXTURE0);
}

Result<ContactMap> ContactMap::create(const GlTable& gl) {
  using namespace shader;
  auto items = CasterDraw::create(gl);
  if (!items) return items.error();
  auto ground = ShaderProgram::link(gl, "contact with the ground", kGroundVertex, kFlatFragment);
  if (!ground) return ground.error();
  auto openness = ShaderProgram::link(gl, "openness", kWholeVertex, kOpennessFragment);
  if (!openness) return openness.error();
  auto evened = ShaderProgram::link(gl, "openness, evened", kWholeVertex, kEvenedFragment);
  if (!evened) return evened.error();
  return ContactMap(gl, std::move(*items), std::move(*ground), std::move(*openness),
                    std::move(*evened));
}

ContactMap::ContactMap(const GlTable& gl, CasterDraw items, ShaderProgram ground,
                       ShaderProgram openness, ShaderProgram evened)
    : gl_(gl),
      items_(std::move(items)),
      ground_(std::move(ground)),
      openness_(std::move(openness)),
      evened_(std::move(evened)) {}

/// Leaves one of its framebuffers bound when it creates them.
Result<const ContactMap::Target*> ContactMap::targetOf(std::size_t view, int width, int height) {
  const auto found = targets_.find(view);
  if (found != targets_.end()) {
    if (found->second.width == width && found->second.height == height) return &found->second;
    targets_.erase(found);
  }
  Target target;
  target.width = width;
  target.height = height;
  bool complete = true;
  const auto make = [&](GlTexture& texture, GlFramebuffer& frame, bool is_depth) {
    texture = GlTexture(gl_);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, is_depth ? GL_DEPTH_COMPONENT32F : GL_RG32F, width, height, 0,
                   is_depth ? GL_DEPTH_COMPONENT : GL_RG, GL_FLOAT, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    frame = GlFramebuffer(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                             GL_TEXTURE_2D, texture, 0);
    if (is_depth) {
      gl_.DrawBuffer(GL_NONE);
      gl_.ReadBuffer(GL_NONE);
    }
    complete = complete && gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  };
  make(target.depth, target.depth_frame, true);
  make(target.first, target.first_frame, false);
  make(target.second, target.second_frame, false);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  if (!complete) {
    return Error{ErrorKind::refused, "the GL driver cannot create a framebuffer for contact", {}};
  }
  return &targets_.emplace(view, std::move(target)).first->second;
}

void ContactMap::drawDepths(const Target& target, std::span<const DrawnSet> sets,
                            const Camera& camera, double ground_m) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target.depth_frame);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_GEQUAL);
  gl_.DepthMask(GL_TRUE);
  gl_.ClearDepth(0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  items_.draw(sets, camera);
  gl_.BindVertexArray(empty_array_);
  // From below it hides nothing.
  if (!(ground_m > 0) || !(camera.eye().z > 0)) return;
  ground_.use();
  const glm::mat4 clip_from_relative(camera.clipFromRelative());
  gl_.UniformMatrix4fv(ground_.uniform("clip_from_relative"), 1, GL_FALSE,
                       glm::value_ptr(clip_from_relative));
  const glm::vec3 center(-camera.eye());
  gl_.Uniform3f(ground_.uniform("center_from_eye"), center.x, center.y, center.z);
  gl_.Uniform1f(ground_.uniform("half_size"), static_cast<float>(ground_m));
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void ContactMap::drawOpenness(const Target& target, const Camera& camera) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target.first_frame);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.BindTexture(GL_TEXTURE_2D, target.depth);
  openness_.use();
  gl_.Uniform1i(openness_.uniform("depths"), 0);
  const glm::vec4 terms = depthTerms(camera, gl_.ClipControl != nullptr);
  gl_.Uniform4f(openness_.uniform("depth_terms"), terms.x, terms.y, terms.z, terms.w);
  const double metres = camera.metersPerPixel(1) / 2;
  gl_.Uniform2f(openness_.uniform("half_extent"),
                static_cast<float>(metres * camera.width() * camera.pixelAspect()),
                static_cast<float>(metres * camera.height()));
  gl_.Uniform2f(openness_.uniform("center"), static_cast<float>(camera.center().x),
                static_cast<float>(camera.center().y));
  gl_.Uniform1i(openness_.uniform("orthographic"), camera.orthographic() ? 1 : 0);
  gl_.Uniform1f(openness_.uniform("reach_m"), kReach);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void ContactMap::even(const Target& target) const {
  evened_.use();
  gl_.Uniform1i(evened_.uniform("open"), 0);
  const GLint along = evened_.uniform("along");
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target.second_frame);
  gl_.BindTexture(GL_TEXTURE_2D, target.first);
  gl_.Uniform2f(along, 1, 0);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target.first_frame);
  gl_.BindTexture(GL_TEXTURE_2D, target.second);
  gl_.Uniform2f(along, 0, 1);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

Result<ContactLookup> ContactMap::draw(std::size_t view, std::span<const DrawnSet> sets,
                                       const Camera& camera, double ground_m,
                                       const glm::vec2& origin) {
  GLint bound = 0;
  gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const auto target = targetOf(view, (camera.width() + 1) / 2, (camera.height() + 1) / 2);
  if (!target) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
    return target.error();
  }
  const Target& map = **target;
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.Viewport(0, 0, map.width, map.height);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.ActiveTexture(GL_TEXTURE0);
  if (camera.orthographic() && gl_.clamps_depth) gl_.Enable(GL_DEPTH_CLAMP);
  drawDepths(map, sets, camera, ground_m);
  if (gl_.clamps_depth) gl_.Disable(GL_DEPTH_CLAMP);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  drawOpenness(map, camera);
  even(map);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  return ContactLookup{map.first,
                       origin,
                       {static_cast<float>(map.width) / static_cast<float>(camera.width()),
                        static_cast<float>(map.height) / static_cast<float>(camera.height())}};
}

}  // namespace rocinante
