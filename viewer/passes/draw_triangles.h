#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/gl/gl_table.h"

namespace rocinante {

/// Draws the triangles of items with the program in use, one-sided triangles with culling. Culling
/// must be off before and is off after destruction. An item's mesh must be bound
/// (MeshBuffers::bind). Borrows its arguments.
class TriangleDrawer {
 public:
  TriangleDrawer(const GlTable& gl, const SceneCatalog& catalog) : gl_(gl), catalog_(catalog) {}
  ~TriangleDrawer() { cull(Culled::nothing); }
  TriangleDrawer(const TriangleDrawer&) = delete;
  TriangleDrawer& operator=(const TriangleDrawer&) = delete;

  void draw(const DrawItem& item);
  /// Sets culling as draw() would, for items drawn by other means whose triangles are all one-sided
  /// or all two-sided.
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
  Culled culled_ = Culled::nothing;  // GL's current state
};

/// Draws a single item.
inline void drawTriangles(const GlTable& gl, const DrawItem& item, const SceneCatalog& catalog) {
  TriangleDrawer(gl, catalog).draw(item);
}

}  // namespace rocinante
