#pragma once

#include <optional>

#include "viewer/passes/background_pass.h"
#include "viewer/passes/grid_pass.h"
#include "viewer/passes/overlay_pass.h"
#include "viewer/passes/scene_pass.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// The draw stage: only GL calls. Every pass draws into the bound framebuffer. Call begin() before
/// the first pass and end() after the last. Its context must be current.
struct DrawPasses {
  /// Begins its programs, which the driver compiles while other things are made ready.
  explicit DrawPasses(const GlTable& table)
      : gl(table), scene(table), background(table), grid(table), overlay(table) {}

  /// What is needed to draw these surfaces, and the lights of `look`: before begin(). Waits for the
  /// driver on first use. refused with the compiler's message.
  Status prepare(const SurfaceLook& surfaces, const CellScene& look);

  /// The depth range that a Camera must have for these passes.
  ClipDepth clipDepth() const {
    return gl.ClipControl != nullptr ? ClipDepth::zero_to_one : ClipDepth::minus_one_to_one;
  }

  /// Draws the background of a part of the framebuffer and clears its depths; all passes draw only
  /// there until the next call; with `only` what lies in both.
  void begin(const CellScene& look, const PixelRectangle& part, int frame_height,
             const std::optional<PixelRectangle>& only = {});
  /// For the overlay pass alone, over existing pixels; clears nothing.
  void beginOnTop(const PixelRectangle& part, int frame_height,
                  const std::optional<PixelRectangle>& only = {}) const;
  /// Restores a neutral GL state: no depth test, no blending, nothing bound.
  void end() const;

  const GlTable& gl;
  ScenePass scene;
  BackgroundPass background;
  GridPass grid;
  OverlayPass overlay;
};

}  // namespace rocinante
