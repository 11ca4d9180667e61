#include "viewer/gl/frame_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>

namespace rocinante {
namespace {

Error badFrame(std::string what) { return Error{ErrorKind::bad_argument, std::move(what), {}}; }

Error noMemory(int width, int height, int samples) {
  return {
      ErrorKind::refused,
      fmt::format("not enough memory for a frame of {}x{} with {} samples", width, height, samples),
      {}};
}

/// Upper bound of a frame's memory: colour and depth of each sample, the resolved buffers and the
/// read picture.
std::uint64_t memoryOf(int width, int height, int samples) {
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  return pixels * (static_cast<std::uint64_t>(samples) * 8 + 8);
}

/// Available memory; unlimited when Linux does not report it. Checked because large allocations
/// succeed first and kill the process later.
std::uint64_t availableBytes() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    std::uint64_t kibibytes = 0;
    if (std::sscanf(line.c_str(), "MemAvailable: %" SCNu64, &kibibytes) == 1) {
      return kibibytes * 1024;
    }
  }
  return ~std::uint64_t{0};
}

/// Allocates a new renderbuffer and leaves it bound. Returns its number of samples: a renderer may
/// round up.
int storeSamples(const GlTable& gl, GlRenderbuffer& name, GLenum format, int width, int height,
                 int samples) {
  name = GlRenderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width,
                                    height);
  GLint got = 0;
  gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &got);
  return std::max(got, 1);
}

}  // namespace

int FrameBuffer::mostSamples(const GlTable& gl) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most);
  return std::max(most, 1);
}

Result<FrameBuffer> FrameBuffer::create(const GlTable& gl, int width, int height, int samples) {
  GLint max_side = 0;
  const int max_samples = mostSamples(gl);
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &max_side);
  if (width < 1 || height < 1 || width > max_side || height > max_side) {
    return badFrame(fmt::format("cannot draw a frame of {}x{}: each side must be 1 to {} here",
                                width, height, max_side));
  }
  if (samples < 1 || samples > max_samples) {
    return badFrame(
        fmt::format("cannot draw {} samples: this renderer has 1 to {}", samples, max_samples));
  }

  // Ordinary sizes need no check.
  constexpr std::uint64_t kLarge = std::uint64_t{1} << 30;
  const std::uint64_t bytes = memoryOf(width, height, samples);
  if (bytes > kLarge && bytes > availableBytes()) return noMemory(width, height, samples);

  FrameBuffer frame(gl);
  frame.width_ = width;
  frame.height_ = height;
  frame.samples_ = samples;
  frame.frame_ = GlFramebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame.frame_);
  // Float depth, because it runs from near (1) to far (0): see camera.h.
  const int color = storeSamples(gl, frame.color_, GL_RGBA8, width, height, samples);
  const int depth = storeSamples(gl, frame.depth_, GL_DEPTH_COMPONENT32F, width, height, samples);
  if (gl.GetError() == GL_OUT_OF_MEMORY) return noMemory(width, height, samples);
  if (color != samples || depth != samples) {
    return badFrame(fmt::format("cannot draw {} samples: this renderer has {}", samples, color));
  }
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, frame.color_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, frame.depth_);
  bool complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (complete && samples > 1) {
    frame.resolved_frame_ = GlFramebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.resolved_frame_);
    storeSamples(gl, frame.resolved_color_, GL_RGBA8, width, height, 1);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               frame.resolved_color_);
    complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  if (gl.GetError() == GL_OUT_OF_MEMORY) return noMemory(width, height, samples);
  if (!complete) {
    return Error{ErrorKind::refused,
                 fmt::format("the GL driver cannot create a framebuffer of {}x{} with {} samples",
                             width, height, samples),
                 {}};
  }
  return frame;
}

FrameBuffer FrameBuffer::ofContext(const GlTable& gl, int width, int height) {
  FrameBuffer frame(gl);
  frame.width_ = width;
  frame.height_ = height;
  return frame;
}

void FrameBuffer::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_->Viewport(0, 0, width_, height_);
}

void FrameBuffer::resolve() const {
  if (samples_ > 1) {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_frame_);
    gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
  }
  gl_->BindFramebuffer(GL_FRAMEBUFFER, resolved());
  gl_->Viewport(0, 0, width_, height_);
}

Picture FrameBuffer::read() const {
  Picture picture;
  picture.width = width_;
  picture.height = height_;
  const std::size_t row_bytes = static_cast<std::size_t>(width_) * 4;
  picture.rgba.resize(row_bytes * static_cast<std::size_t>(height_));
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  // GL's first row is the bottom one.
  for (int y = 0; y < height_ / 2; ++y) {
    auto top = picture.rgba.begin() + static_cast<std::ptrdiff_t>(row_bytes) * y;
    auto bottom = picture.rgba.begin() + static_cast<std::ptrdiff_t>(row_bytes) * (height_ - 1 - y);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row_bytes), bottom);
  }
  return picture;
}

void FrameBuffer::stretchTo(const FrameBuffer& target) const {
  stretchPartTo({0, 0, width_, height_}, target, {0, 0, target.width_, target.height_});
}

void FrameBuffer::stretchPartTo(const PixelRectangle& part, const FrameBuffer& target,
                                const PixelRectangle& target_part) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.resolved());
  // The scissor clips copies too.
  gl_->Disable(GL_SCISSOR_TEST);
  const int bottom = height_ - part.y - part.height;
  const int target_bottom = target.height_ - target_part.y - target_part.height;
  gl_->BlitFramebuffer(part.x, bottom, part.x + part.width, bottom + part.height, target_part.x,
                       target_bottom, target_part.x + target_part.width,
                       target_bottom + target_part.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void FrameBuffer::copyPartTo(const PixelRectangle& part, const FrameBuffer& target, int x,
                             int y) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.resolved());
  gl_->Disable(GL_SCISSOR_TEST);
  const int bottom = height_ - part.y - part.height;
  const int left = part.x + x;
  const int target_bottom = target.height() - (part.y + y) - part.height;
  gl_->BlitFramebuffer(part.x, bottom, part.x + part.width, bottom + part.height, left,
                       target_bottom, left + part.width, target_bottom + part.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void FrameBuffer::blitTo(GLuint target) const {
  if (resolved() != target) {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
  }
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target);
}

}  // namespace rocinante
