#include "viewer/passes/backdrop_pass.h"

#include <string_view>
#include <utility>

#include "viewer/view/camera.h"

namespace rocinante {
namespace {

constexpr std::string_view kVertex = R"(#version 330 core
uniform vec4 sides;  // in clip space: left, bottom, right, top
out vec2 map_place;
void main() {
  vec2 part = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  map_place = vec2(part.x, 1.0 - part.y);
  gl_Position = vec4(mix(sides.xy, sides.zw, part), 0.0, 1.0);
}
)";

constexpr std::string_view kFragment = R"(#version 330 core
in vec2 map_place;
uniform sampler2D map;
uniform float opacity;
out vec4 color;
void main() {
  vec4 texel = texture(map, map_place);
  color = vec4(texel.rgb, texel.a * opacity);
}
)";

}  // namespace

Result<BackdropPass> BackdropPass::create(const GlTable& gl) {
  auto program = ShaderProgram::link(gl, "backdrop", kVertex, kFragment);
  if (!program) return program.error();
  return BackdropPass(gl, std::move(*program));
}

BackdropPass::BackdropPass(const GlTable& gl, ShaderProgram program)
    : gl_(gl), program_(std::move(program)) {}

void BackdropPass::upload(const BackdropPicture& picture) {
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  if (uploaded_ == picture.number) return;
  GLint max_side = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  GLint level = 0;
  for (const Picture& pixels : picture.levels) {
    if (pixels.width > max_side || pixels.height > max_side) continue;
    gl_.TexImage2D(GL_TEXTURE_2D, level++, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, pixels.rgba.data());
  }
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  uploaded_ = picture.number;
}

void BackdropPass::draw(const BackdropPicture& picture, const CameraIntrinsics& lens, int width,
                        int height, double opacity) {
  if (picture.levels.empty() || !(opacity > 0)) return;
  upload(picture);
  const LensFit fit = fitOf(lens, width, height);
  const auto across = [&](double x) { return static_cast<float>(2 * x / width - 1); };
  const auto upward = [&](double y) { return static_cast<float>(1 - 2 * y / height); };
  program_.use();
  gl_.Uniform4f(program_.uniform("sides"), across(fit.left), upward(fit.bottom(lens)),
                across(fit.right(lens)), upward(fit.top));
  gl_.Uniform1f(program_.uniform("opacity"), static_cast<float>(opacity));
  gl_.Uniform1i(program_.uniform("map"), 0);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BindVertexArray(empty_array_);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_.Disable(GL_BLEND);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace rocinante
