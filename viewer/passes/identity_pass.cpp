#include "viewer/passes/identity_pass.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <utility>

#include "core/mesh/mesh.h"
#include "viewer/gl/depth_lift.h"
#include "viewer/gl/viewport.h"
#include "viewer/passes/draw_triangles.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {
namespace {

/// A blended picture's pixel belongs to it where it is more opaque than not.
constexpr float kOwnsFrom = 0.5F;

constexpr std::string_view kSurfaceFragment = R"(#version 330 core
in vec2 map_place;
uniform vec4 number;
uniform bool has_holes;
uniform sampler2D map;
uniform float cutoff;
out vec4 color;
void main() {
  if (has_holes && texture(map, map_place).a < cutoff) discard;
  color = number;
}
)";

constexpr std::string_view kFlatVertex = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec2 disc_place;
layout(location = 2) in vec4 vertex_number;
layout(location = 3) in uint vertex_kind;
out vec2 place;
flat out vec4 number;
flat out uint kind;
void main() {
  gl_Position = clip;
  place = disc_place;
  number = vertex_number;
  kind = vertex_kind;
}
)";

// Text is on a plate of the same drawing.
constexpr std::string_view kFlatFragment = R"(#version 330 core
in vec2 place;
flat in vec4 number;
flat in uint kind;
out vec4 color;
void main() {
  if (kind == 2u || (kind == 1u && dot(place, place) > 1.0)) discard;
  color = number;
}
)";

}  // namespace

Result<IdentityPass> IdentityPass::create(const GlTable& gl) {
  auto surface = ShaderProgram::link(gl, "identity", shader::kMappedVertex, kSurfaceFragment);
  if (!surface) return surface.error();
  auto flat = ShaderProgram::link(gl, "identity overlay", kFlatVertex, kFlatFragment);
  if (!flat) return flat.error();
  return IdentityPass(gl, std::move(*surface), std::move(*flat));
}

IdentityPass::IdentityPass(const GlTable& gl, ShaderProgram surface, ShaderProgram flat)
    : gl_(gl),
      surface_(std::move(surface)),
      flat_(std::move(flat)),
      clip_from_model_(surface_.uniform("clip_from_model")),
      map_along_(surface_.uniform("map_along")),
      map_offset_(surface_.uniform("map_offset")),
      has_holes_(surface_.uniform("has_holes")),
      cutoff_(surface_.uniform("cutoff")),
      number_(surface_.uniform("number")),
      buffer_(gl) {}

void IdentityPass::begin(const PixelRectangle& part, int frame_height) const {
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  setViewport(gl_, part, frame_height);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ZERO);  // other passes may enable blending
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.DepthMask(GL_TRUE);
  gl_.ClearColor(0, 0, 0, 0);
  gl_.ClearDepth(0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_GEQUAL);
}

glm::vec4 IdentityPass::colorOf(std::uint32_t number) {
  // A byte divided by 255 as a float reads back exactly: 8-bit components round to nearest.
  const auto component = [&](unsigned shift) {
    return static_cast<float>(number >> shift & 255U) / 255.0F;
  };
  return {component(0), component(8), component(16), component(24)};
}

void IdentityPass::drawItem(const DrawItem& item, float depth_ranks, const DrawnSet& set,
                            const TextureStore& textures, const Camera& camera,
                            std::uint32_t number) const {
  surface_.use();
  const glm::mat4 clip_from_model(camera.clipFromRelative() * camera.relative(item.world));
  gl_.UniformMatrix4fv(clip_from_model_, 1, GL_FALSE, glm::value_ptr(clip_from_model));
  const glm::vec4 color = colorOf(number);
  gl_.Uniform4f(number_, color.r, color.g, color.b, color.a);
  const auto texture = static_cast<std::size_t>(std::max(item.texture, 0));
  const bool has_holes = item.texture >= 0 && textures.name(texture) != 0 &&
                         (item.is_cut || textures.translucent()[texture] != 0);
  gl_.Uniform1i(has_holes_, has_holes ? 1 : 0);
  if (has_holes) {
    const MapPlacing placing(*item.material);
    textures.bind(texture);
    gl_.Uniform1f(cutoff_, item.is_cut ? item.cutoff : kOwnsFrom);
    gl_.Uniform4f(map_along_, placing.along_u.x, placing.along_u.y, placing.along_v.x,
                  placing.along_v.y);
    gl_.Uniform2f(map_offset_, placing.offset.x, placing.offset.y);
  }
  if (depth_ranks != 0) {
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    setDepthLift(gl_, depth_ranks, item.lift_units);
  }
  set.meshes->bind(item.mesh);
  drawTriangles(gl_, item, *set.catalog);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void IdentityPass::drawOverlay(const Overlay& overlay, const std::vector<std::uint32_t>& numbers,
                               bool in_scene) const {
  assert(numbers.size() == overlay.vertices().size());
  // R, G, B, A in memory start at the number's lowest byte, as read by readNumbers().
  std::vector<OverlayVertex> vertices;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    vertices.push_back(overlay.vertices()[i]);
    vertices.back().abgr = numbers[i];
  }
  if (vertices.empty()) return;
  if (!in_scene) gl_.Disable(GL_DEPTH_TEST);
  flat_.use();
  buffer_.draw(vertices);
  gl_.Enable(GL_DEPTH_TEST);
}

void IdentityPass::end() const {
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.ClearDepth(1);
  gl_.BindVertexArray(0);
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.UseProgram(0);
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

std::vector<std::uint32_t> IdentityPass::readNumbers(const FrameBuffer& drawn) {
  const Picture picture = drawn.read();
  std::vector<std::uint32_t> numbers;
  numbers.reserve(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    std::uint32_t number = 0;
    for (std::size_t byte = 4; byte-- > 0;) number = number << 8U | picture.rgba[i + byte];
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<float> IdentityPass::readDepth(const FrameBuffer& drawn, const Camera& camera) const {
  const auto width = static_cast<std::size_t>(drawn.width());
  const auto height = static_cast<std::size_t>(drawn.height());
  std::vector<float> stored(width * height);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, drawn.width(), drawn.height(), GL_DEPTH_COMPONENT, GL_FLOAT, stored.data());
  std::vector<float> metres;
  metres.reserve(stored.size());
  for (std::size_t y = height; y-- > 0;) {
    for (std::size_t x = 0; x < width; ++x) {
      const double depth = stored[y * width + x];
      metres.push_back(depth > 0 ? static_cast<float>(camera.depthAt(depth))
                                 : std::numeric_limits<float>::infinity());
    }
  }
  return metres;
}

std::vector<NumberedPixel> IdentityPass::readPart(const PixelRectangle& part, int frame_height,
                                                  const Camera& camera) const {
  const auto count = static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height);
  std::vector<std::uint8_t> bytes(count * 4);
  std::vector<float> stored(count);
  const int bottom = frame_height - part.y - part.height;
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(part.x, bottom, part.width, part.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  // A browser gives no depth: there it is infinitely far.
  if (!gl_.is_embedded) {
    gl_.ReadPixels(part.x, bottom, part.width, part.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                   stored.data());
  }
  std::vector<NumberedPixel> pixels;
  for (int y = part.height - 1; y >= 0; --y) {
    for (int x = 0; x < part.width; ++x) {
      const auto place = static_cast<std::size_t>(y * part.width + x);
      NumberedPixel pixel{part.x + x, part.y + part.height - 1 - y, 0,
                          camera.depthAt(stored[place])};
      for (std::size_t byte = 4; byte-- > 0;) {
        pixel.number = pixel.number << 8U | bytes[place * 4 + byte];
      }
      pixels.push_back(pixel);
    }
  }
  return pixels;
}

}  // namespace rocinante
