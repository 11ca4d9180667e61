#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/gl/gl_table.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws many small items as one: to tell GL of a box takes longer than to move its corners, so
/// they are moved here, by the arithmetic of the scene's vertex shader and in its order. A frame
/// has the same bits whether its items were drawn so or one by one (tested). Attributes 0 to 2:
/// clip (vec4), from_eye (vec3, world axes) and normal (vec3, any length), as ItemMatrices makes
/// them.
///
/// Its context must be current whenever it is used or destroyed.
class ItemBatch {
 public:
  explicit ItemBatch(const GlTable& gl);
  ~ItemBatch();
  ItemBatch(ItemBatch&& other) noexcept;
  ItemBatch& operator=(ItemBatch&&) = delete;

  /// How many of the first items are drawn alike and can be drawn as one; 0: not even the first.
  /// Sides that are culled are the same for all of them, as are looks and lifts.
  static std::size_t reach(std::span<const DrawItem> items, const SceneCatalog& catalog);
  /// From here on it pays.
  static constexpr std::size_t kLeastItems = 4;

  /// Draws the items, of which reach() said that they can be, with whatever program is in use.
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
  GLuint array_ = 0, vertex_buffer_ = 0, index_buffer_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace rocinante
