#include "viewer/passes/outline_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/math/transform.h"
#include "viewer/passes/draw_triangles.h"
#include "viewer/passes/look_shaders.h"

namespace rocinante {
namespace {

constexpr glm::vec4 kLineColor{1.0F, 0.58F, 0.05F, 1};
constexpr double kLineWidthPx = 2.5;

/// Reach of the line in pixels along an axis.
int outlineReach(double scale) { return static_cast<int>(std::ceil(kLineWidthPx * scale - 0.5)); }

/// Coverage by squared distance: line width plus half a pixel minus the distance, at most one.
std::vector<std::uint8_t> coverBySquare(int reach, double scale) {
  std::vector<std::uint8_t> cover;
  for (int square = 0; square <= 2 * (reach + 1) * (reach + 1); ++square) {
    const double left = kLineWidthPx * scale + 0.5 - std::sqrt(square);
    cover.push_back(static_cast<std::uint8_t>(std::clamp(left, 0.0, 1.0) * 255 + 0.5));
  }
  cover[0] = 0;
  return cover;
}

/// Bounding box of the items in pixels from the bottom left.
struct CoveredBox {
  double left = 1e9, bottom = 1e9, right = -1e9, top = -1e9;
};

void addItem(CoveredBox& box, const DrawItem& item, const CatalogPart& part, const Camera& camera) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                    (corner & 4U) != 0 ? 1 : -1);
    const Vec4 clip = camera.clipOf(transformPoint(item.world, part.center + sign * part.half));
    // A corner behind the eye makes the box unbounded.
    const bool behind = !camera.orthographic() && !(clip.w > camera.near());
    const double x = behind ? 0 : clip.x / clip.w;
    const double y = behind ? 0 : clip.y / clip.w;
    const double spread = behind ? 1 : 0;
    box.left = std::min(box.left, (x - spread + 1) / 2 * camera.width());
    box.right = std::max(box.right, (x + spread + 1) / 2 * camera.width());
    box.bottom = std::min(box.bottom, (y - spread + 1) / 2 * camera.height());
    box.top = std::max(box.top, (y + spread + 1) / 2 * camera.height());
  }
}

int boundedPixel(double place, int most) {
  if (!(place > 0)) return 0;
  return place < most ? static_cast<int>(place) : most;
}

}  // namespace

std::vector<std::uint8_t> outlineOf(const std::vector<std::uint8_t>& covered, int width, int height,
                                    double scale) {
  const int reach = outlineReach(scale);
  const std::vector<std::uint8_t> cover_by_square = coverBySquare(reach, scale);
  const auto w = static_cast<std::size_t>(width);
  const auto h = static_cast<std::size_t>(height);
  // First along each row: the squared distance to a covered pixel, or this if too far.
  const auto far = static_cast<std::uint8_t>((reach + 1) * (reach + 1));
  std::vector<std::uint8_t> along(covered.size(), far);
  for (std::size_t y = 0; y < h; ++y) {
    const std::uint8_t* from = &covered[y * w];
    std::uint8_t* to = &along[y * w];
    for (std::size_t x = 0; x < w; ++x) {
      if (from[x] == 0) continue;
      to[x] = 0;
      for (std::size_t off = 1; off <= static_cast<std::size_t>(reach); ++off) {
        const auto square = static_cast<std::uint8_t>(off * off);
        if (x >= off) to[x - off] = std::min(to[x - off], square);
        if (x + off < w) to[x + off] = std::min(to[x + off], square);
      }
    }
  }
  // Then along columns.
  std::vector<std::uint8_t> cover(covered.size(), 0);
  std::vector<std::uint8_t> nearest(w);
  for (std::size_t y = 0; y < h; ++y) {
    std::fill(nearest.begin(), nearest.end(), far);
    for (int off = -reach; off <= reach; ++off) {
      const int row = static_cast<int>(y) + off;
      if (row < 0 || row >= height) continue;
      const std::uint8_t* from = &along[static_cast<std::size_t>(row) * w];
      const auto square = static_cast<std::uint8_t>(off * off);
      for (std::size_t x = 0; x < w; ++x) {
        nearest[x] = std::min(nearest[x], static_cast<std::uint8_t>(from[x] + square));
      }
    }
    for (std::size_t x = 0; x < w; ++x) cover[y * w + x] = cover_by_square[nearest[x]];
  }
  return cover;
}

Result<OutlinePass> OutlinePass::create(const GlTable& gl) {
  auto mask = ShaderProgram::link(gl, "mask", shader::kFlatVertex, shader::kFlatFragment);
  if (!mask) return mask.error();
  auto line = ShaderProgram::link(gl, "outline", shader::kOutlineVertex, shader::kOutlineFragment);
  if (!line) return line.error();
  return OutlinePass(gl, std::move(*mask), std::move(*line));
}

OutlinePass::OutlinePass(const GlTable& gl, ShaderProgram mask, ShaderProgram line)
    : gl_(gl), mask_(std::move(mask)), line_(std::move(line)) {}

Status OutlinePass::resize(int width, int height) {
  if (frame_ != 0 && width == width_ && height == height_) return {};
  if (frame_ == 0) frame_ = GlFramebuffer(gl_);
  if (covered_ == 0) covered_ = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, covered_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, covered_, 0);
  width_ = width;
  height_ = height;
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return Error{ErrorKind::refused, "the GL driver cannot create a framebuffer for outlines", {}};
  }
  return {};
}

Status OutlinePass::find(std::span<const DrawnSet> sets, const Camera& camera, double scale) {
  found_ = false;
  GLint bound = 0;
  gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  Status ready = resize(camera.width(), camera.height());
  if (ready) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    mask_.use();
    const GLint clip = mask_.uniform("clip_from_model");
    gl_.Uniform4f(mask_.uniform("flat_color"), 1, 1, 1, 1);
    CoveredBox box;
    for (const DrawnSet& set : sets) {
      const DrawList& list = *set.list;
      for (const auto* items : {&list.opaque, &list.translucent, &list.wireframe, &list.ghosts}) {
        for (const DrawItem& item : *items) {
          if (!item.outlined) continue;
          found_ = true;
          const glm::mat4 clip_from_model(camera.clipFromRelative() * camera.relative(item.world));
          gl_.UniformMatrix4fv(clip, 1, GL_FALSE, glm::value_ptr(clip_from_model));
          set.meshes->bind(item.mesh);
          drawTriangles(gl_, item, *set.catalog);
          addItem(box, item, set.catalog->meshes()[item.mesh].parts[item.part], camera);
        }
      }
    }
    const int reach = outlineReach(scale);
    left_ = boundedPixel(box.left - reach - 1, width_);
    right_ = boundedPixel(box.right + reach + 2, width_);
    bottom_ = boundedPixel(box.bottom - reach - 1, height_);
    top_ = boundedPixel(box.top + reach + 2, height_);
    if (found_) makeLine(scale);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  return ready;
}

void OutlinePass::makeLine(double scale) {
  const int width = right_ - left_;
  const int height = top_ - bottom_;
  found_ = width > 0 && height > 0;
  if (!found_) return;
  std::vector<std::uint8_t> covered(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(left_, bottom_, width, height, GL_RED, GL_UNSIGNED_BYTE, covered.data());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  const std::vector<std::uint8_t> cover = outlineOf(covered, width, height, scale);
  if (cover_ == 0) cover_ = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, cover_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, cover.data());
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void OutlinePass::draw() const {
  if (!found_) return;
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  line_.use();
  gl_.Uniform4f(line_.uniform("box"), static_cast<float>(left_), static_cast<float>(bottom_),
                static_cast<float>(right_), static_cast<float>(top_));
  gl_.Uniform2f(line_.uniform("size"), static_cast<float>(width_), static_cast<float>(height_));
  gl_.Uniform4f(line_.uniform("line_color"), kLineColor.r, kLineColor.g, kLineColor.b,
                kLineColor.a);
  gl_.BindTexture(GL_TEXTURE_2D, cover_);
  gl_.BindVertexArray(empty_array_);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_.Disable(GL_BLEND);
}

}  // namespace rocinante
