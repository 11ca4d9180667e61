#pragma once

#include <cstdint>
#include <vector>

#include "viewer/gl/frame_buffer.h"
#include "viewer/gl/shader_program.h"
#include "viewer/overlay/overlay.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/passes/ghost_pass.h"
#include "viewer/passes/overlay_buffer.h"
#include "viewer/passes/texture_store.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// The number and depth of a pixel, from the top left of the frame.
struct NumberedPixel {
  int x = 0, y = 0;
  std::uint32_t number = 0;  ///< 0: nothing
  double depth_m = 0;        ///< along the view; infinity: nothing drawn
};

/// Draws numbers instead of colours: a pixel's four bytes are exactly a number. Uses a frame's draw
/// list and overlays, so that both agree. Draws into the bound framebuffer, which must have one
/// sample per pixel; its context must be current.
class IdentityPass {
 public:
  static Result<IdentityPass> create(const GlTable& gl);

  /// Clears a part of the framebuffer to 0, and draws only there until the next call.
  void begin(const PixelRectangle& part, int frame_height) const;
  /// Draws `number_of(item)` for each surface; the nearest one owns a pixel, translucent or not. In
  /// the frame's order, which decides at equal depths.
  template <class NumberOf>
  void drawSurfaces(const DrawnSet& set, const TextureStore& textures, const Camera& camera,
                    const NumberOf& number_of) const {
    const DrawList& list = *set.list;
    for (const auto* items : {&list.opaque, &list.ghosts, &list.translucent}) {
      for (const DrawItem& item : *items) {
        const float ranks = items == &list.ghosts ? GhostPass::kBehindRanks
                                                  : static_cast<float>(item.coplanar_rank);
        drawItem(item, ranks, set, textures, camera, number_of(item));
      }
    }
  }
  /// A number as a colour for other passes; without blending it reads back exactly.
  static glm::vec4 colorOf(std::uint32_t number);
  /// Draws numbers by vertex; 0 draws nothing. `in_scene`: depth-tested.
  void drawOverlay(const Overlay& overlay, const std::vector<std::uint32_t>& numbers,
                   bool in_scene) const;
  /// Restores GL's state from before begin().
  void end() const;

  /// The numbers of all pixels, top row first.
  static std::vector<std::uint32_t> readNumbers(const FrameBuffer& drawn);
  /// Metres along the view, top row first; infinity where nothing was drawn.
  std::vector<float> readDepth(const FrameBuffer& drawn, const Camera& camera) const;
  /// A few pixels of the bound frame, of that height, top row first.
  std::vector<NumberedPixel> readPart(const PixelRectangle& part, int frame_height,
                                      const Camera& camera) const;

 private:
  IdentityPass(const GlTable& gl, ShaderProgram surface, ShaderProgram flat);
  void drawItem(const DrawItem& item, float depth_ranks, const DrawnSet& set,
                const TextureStore& textures, const Camera& camera, std::uint32_t number) const;

  const GlTable& gl_;
  ShaderProgram surface_, flat_;
  GLint clip_from_model_, map_along_, map_offset_, has_holes_, cutoff_, number_;
  OverlayBuffer buffer_;
};

}  // namespace rocinante
