#pragma once

#include "core/base/result.h"
#include "viewer/gl/gl_name.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// The framebuffer object of all frames, so that frames are byte-identical in every context (a
/// default framebuffer differs). RGBA8 without sRGB and 32-bit float depth; with more than one
/// sample, a second, resolved buffer to read from. Its context must be current whenever it is used
/// or destroyed.
class FrameBuffer {
 public:
  /// bad_argument when the renderer does not support exactly these samples or this size; refused
  /// when memory is insufficient.
  static Result<FrameBuffer> create(const GlTable& gl, int width, int height, int samples);

  /// Samples per pixel that this renderer has, at least 1.
  static int mostSamples(const GlTable& gl);

  /// The context's own, which something else made and keeps: one sample, perhaps no depth.
  static FrameBuffer ofContext(const GlTable& gl, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }
  bool isOfContext() const { return frame_ == 0; }

  /// Binds it for drawing with all samples, and sets the viewport.
  void bind() const;
  /// Averages the samples, then binds the resolved pixels for drawing without multisampling, such
  /// as a user interface. Without depth when samples > 1.
  void resolve() const;
  /// The resolved pixels, top row first. Requires resolve().
  Picture read() const;
  /// Copies the resolved pixels unscaled to the bottom left of framebuffer `target` (0: the
  /// window), unless they are there.
  void blitTo(GLuint target) const;
  /// Copies a part of the resolved pixels into `target`, which must have one sample per pixel, so
  /// that these pixels' upper left corner would be at (x, y) of it; leaves it bound for drawing.
  void copyPartTo(const PixelRectangle& part, const FrameBuffer& target, int x = 0,
                  int y = 0) const;
  /// Fills all of `target`, which must have one sample per pixel, with the resolved pixels,
  /// interpolated if the sizes differ.
  void stretchTo(const FrameBuffer& target) const;
  /// The same for a part of each; leaves `target` bound for drawing.
  void stretchPartTo(const PixelRectangle& part, const FrameBuffer& target,
                     const PixelRectangle& target_part) const;

 private:
  explicit FrameBuffer(const GlTable& gl) : gl_(&gl) {}
  GLuint resolved() const { return samples_ > 1 ? resolved_frame_ : frame_; }

  const GlTable* gl_;
  int width_ = 0;
  int height_ = 0;
  int samples_ = 1;
  GlFramebuffer frame_, resolved_frame_;
  GlRenderbuffer color_, depth_, resolved_color_;
};

}  // namespace rocinante
