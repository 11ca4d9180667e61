#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/gl/gl_name.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws many small items with one call: a draw call for a box costs more than transforming its
/// corners, so they are transformed here, with the arithmetic of the scene's vertex shader in the
/// same order. Frames have the same bits with and without batches (tested). Attributes 0 to 2: clip
/// (vec4), from_eye (vec3, world axes) and normal (vec3, any length), computed by ItemMatrices.
///
/// Its context must be current whenever it is used or destroyed.
class ItemBatch {
 public:
  explicit ItemBatch(const GlTable& gl);

  /// Number of leading items that can be drawn as one batch; 0: not even the first. They share
  /// culling, looks and lifts.
  static std::size_t reach(std::span<const DrawItem> items, const SceneCatalog& catalog);
  /// Smallest batch that is worth it.
  static constexpr std::size_t kLeastItems = 4;

  /// Draws items allowed by reach() with the program in use.
  void draw(std::span<const DrawItem> items, const SceneCatalog& catalog, const Camera& camera);

 private:
  struct Vertex {
    float clip[4];
    float from_eye[3];
    float normal[3];
  };
  void add(const DrawItem& item, const SceneCatalog& catalog, const Camera& camera);
  void flush();

  const GlTable& gl_;
  GlVertexArray array_{gl_};
  GlBuffer vertex_buffer_{gl_}, index_buffer_{gl_};
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace rocinante
