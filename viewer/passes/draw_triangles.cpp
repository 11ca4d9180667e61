#include "viewer/passes/draw_triangles.h"

#include <cstddef>

namespace rocinante {

void TriangleDrawer::draw(const DrawItem& item) {
  const CatalogMesh& mesh = catalog_.meshes()[item.mesh];
  const MeshPart& part = mesh.mesh->parts[item.part];
  const CoarsePart* const coarse = item.coarse;
  const std::uint32_t first_index = coarse != nullptr ? coarse->first_index : part.first_index;
  const std::uint32_t one_sided =
      coarse != nullptr ? coarse->one_sided_count : mesh.parts[item.part].one_sided_count;
  const std::uint32_t two_sided =
      coarse != nullptr ? coarse->two_sided_count : part.index_count - one_sided;
  if (two_sided > 0) {
    cull(Culled::nothing);
    drawRun(first_index, two_sided);
  }
  if (one_sided > 0) {
    cull(backsOf(item));
    drawRun(first_index + two_sided, one_sided);
  }
}

void TriangleDrawer::cullFor(const DrawItem& item) {
  const bool one_sided = catalog_.meshes()[item.mesh].parts[item.part].one_sided_count > 0;
  cull(one_sided ? backsOf(item) : Culled::nothing);
}

void TriangleDrawer::cull(Culled wanted) {
  if (wanted == culled_) return;
  culled_ = wanted;
  if (wanted == Culled::nothing) {
    gl_.Disable(GL_CULL_FACE);
    return;
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.FrontFace(wanted == Culled::backs_of_mirrored ? GL_CW : GL_CCW);
}

void TriangleDrawer::drawRun(std::uint32_t first_index, std::uint32_t count) const {
  const std::size_t offset = std::size_t{first_index} * sizeof(std::uint32_t);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
}

}  // namespace rocinante
