#pragma once

#include "viewer/passes/background_pass.h"
#include "viewer/passes/grid_pass.h"
#include "viewer/passes/overlay_pass.h"
#include "viewer/passes/scene_pass.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// The draw stage: GL calls and nothing else. Every pass draws into whatever framebuffer is bound.
/// Call begin() before the first pass and end() after the last. Its context must be current.
struct DrawPasses {
  static Result<DrawPasses> create(const GlTable& gl, const TextAtlas& atlas);

  /// What a Camera must be made with for these passes.
  ClipDepth clipDepth() const {
    return gl.ClipControl != nullptr ? ClipDepth::zero_to_one : ClipDepth::minus_one_to_one;
  }

  /// Gives a part of the framebuffer its background and clears its depths; all passes draw there
  /// alone until the next call.
  void begin(const CellScene& look, const PixelRectangle& part, int frame_height);
  /// Before the overlay pass alone, over pixels that are there already: clears nothing.
  void beginOnTop(const PixelRectangle& part, int frame_height) const;
  /// Leaves GL's state as a guest expects it: no depth test, no blending, nothing bound.
  void end() const;

  const GlTable& gl;
  ScenePass scene;
  BackgroundPass background;
  GridPass grid;
  OverlayPass overlay;
};

}  // namespace rocinante
