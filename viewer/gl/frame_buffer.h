#pragma once

#include "core/base/result.h"
#include "viewer/gl/gl_table.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// Where every frame is drawn: a framebuffer object of ours, so that frames are byte-identical
/// whatever context they were drawn in (a default framebuffer is not). RGBA8 without sRGB and
/// 32-bit float depth; with more than one sample, a second, resolved one to read from. Bound to the
/// context of its GlTable, which must be current whenever it is used or destroyed.
class FrameBuffer {
 public:
  /// bad_argument when the renderer has not exactly these samples, or not this size; refused when
  /// memory lacks.
  static Result<FrameBuffer> create(const GlTable& gl, int width, int height, int samples);

  ~FrameBuffer();
  FrameBuffer(FrameBuffer&& other) noexcept;
  FrameBuffer& operator=(FrameBuffer&& other) noexcept;

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  /// Drawing goes here: all samples, viewport set.
  void bind() const;
  /// Averages the samples, then draws to the resolved pixels: for what needs no smoothing, such as
  /// a user interface. No depth there when samples > 1.
  void resolve() const;
  /// The resolved pixels, top row first. Call resolve() before.
  Picture read() const;
  /// Copies the resolved pixels one to one into framebuffer `target` (0: the window), at its bottom
  /// left.
  void blitTo(GLuint target) const;
  /// Fills all of `target`, which has one sample a pixel, with the resolved pixels, interpolated
  /// where its size is another.
  void stretchTo(const FrameBuffer& target) const;
  /// The same of a part of each; drawing to `target` goes on then.
  void stretchPartTo(const PixelRectangle& part, const FrameBuffer& target,
                     const PixelRectangle& target_part) const;

 private:
  explicit FrameBuffer(const GlTable& gl) : gl_(&gl) {}
  void release();
  GLuint resolved() const { return samples_ > 1 ? resolved_frame_ : frame_; }

  const GlTable* gl_;
  int width_ = 0;
  int height_ = 0;
  int samples_ = 1;
  GLuint frame_ = 0, color_ = 0, depth_ = 0;
  GLuint resolved_frame_ = 0, resolved_color_ = 0;
};

}  // namespace rocinante
