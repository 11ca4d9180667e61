#include "viewer/render/draw_triangles.h"

#include <cstddef>

namespace rocinante {

void drawTriangles(const GlTable& gl, const DrawItem& item, const SceneCatalog& catalog) {
  const CatalogMesh& mesh = catalog.meshes()[item.mesh];
  const MeshPart& part = mesh.mesh->parts[item.part];
  const CoarsePart* const coarse = item.coarse;
  const std::uint32_t first_index = coarse != nullptr ? coarse->first_index : part.first_index;
  const std::uint32_t one_sided =
      coarse != nullptr ? coarse->one_sided_count : mesh.parts[item.part].one_sided_count;
  const std::uint32_t two_sided =
      coarse != nullptr ? coarse->two_sided_count : part.index_count - one_sided;
  const auto drawRun = [&](std::uint32_t first, std::uint32_t count) {
    const std::size_t offset = std::size_t{first} * sizeof(std::uint32_t);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(offset));
  };
  if (two_sided > 0) drawRun(first_index, two_sided);
  if (one_sided > 0) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_BACK);
    gl.FrontFace(item.mirrored ? GL_CW : GL_CCW);
    drawRun(first_index + two_sided, one_sided);
    gl.Disable(GL_CULL_FACE);
  }
}

}  // namespace rocinante
