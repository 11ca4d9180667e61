#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/gl/gl_table.h"

namespace rocinante {

/// Draws the triangles of item after item with whatever program is in use: those that are seen from
/// their front alone with culling, which is off before, and when this is destroyed. An item's mesh
/// must be bound (MeshBuffers::bind). Borrows both.
class TriangleDrawer {
 public:
  TriangleDrawer(const GlTable& gl, const SceneCatalog& catalog) : gl_(gl), catalog_(catalog) {}
  ~TriangleDrawer() { cull(Culled::nothing); }
  TriangleDrawer(const TriangleDrawer&) = delete;
  TriangleDrawer& operator=(const TriangleDrawer&) = delete;

  void draw(const DrawItem& item);
  /// Culls as draw() would, for who draws the item's triangles by other means: all of them are of
  /// one kind.
  void cullFor(const DrawItem& item);

 private:
  enum class Culled : std::uint8_t { nothing, backs, backs_of_mirrored };
  static Culled backsOf(const DrawItem& item) {
    return item.mirrored ? Culled::backs_of_mirrored : Culled::backs;
  }
  void cull(Culled wanted);
  void drawRun(std::uint32_t first_index, std::uint32_t count) const;

  const GlTable& gl_;
  const SceneCatalog& catalog_;
  Culled culled_ = Culled::nothing;  // as GL was told
};

/// One item by itself.
inline void drawTriangles(const GlTable& gl, const DrawItem& item, const SceneCatalog& catalog) {
  TriangleDrawer(gl, catalog).draw(item);
}

}  // namespace rocinante
