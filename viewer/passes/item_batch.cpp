#include "viewer/passes/item_batch.h"

#include <cstddef>

#include "viewer/passes/item_matrices.h"

namespace rocinante {
namespace {

/// Vertices per upload: few calls, and still cached when drawn.
constexpr std::size_t kVerticesAtOnce = 4096;

/// Whether its triangles are all two-sided or all one-sided.
bool hasOneKindOfSides(const DrawItem& item, const SceneCatalog& catalog) {
  const CatalogMesh& mesh = catalog.meshes()[item.mesh];
  const std::uint32_t one_sided = mesh.parts[item.part].one_sided_count;
  return one_sided == 0 || one_sided == mesh.mesh->parts[item.part].index_count;
}

bool sameSides(const DrawItem& a, const DrawItem& b, const SceneCatalog& catalog) {
  const auto culls = [&](const DrawItem& item) {
    return catalog.meshes()[item.mesh].parts[item.part].one_sided_count > 0;
  };
  return culls(a) == culls(b) && (!culls(a) || a.mirrored == b.mirrored);
}

}  // namespace

ItemBatch::ItemBatch(const GlTable& gl) : gl_(gl) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  const auto attribute = [&](GLuint place, GLint components, std::size_t offset) {
    gl_.EnableVertexAttribArray(place);
    gl_.VertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                            reinterpret_cast<const void*>(offset));
  };
  attribute(0, 4, offsetof(Vertex, clip));
  attribute(1, 3, offsetof(Vertex, from_eye));
  attribute(2, 3, offsetof(Vertex, normal));
  gl_.BindVertexArray(0);
}

std::size_t ItemBatch::reach(std::span<const DrawItem> items, const SceneCatalog& catalog) {
  std::size_t count = 0;
  for (const DrawItem& item : items) {
    const DrawItem& first = items.front();
    if (!item.batched || !hasOneKindOfSides(item, catalog)) break;
    if (item.coplanar_rank != first.coplanar_rank || item.lift_units != first.lift_units) break;
    if (!sameSides(item, first, catalog) || !sameLook(item, first)) break;
    ++count;
  }
  return count;
}

void ItemBatch::draw(std::span<const DrawItem> items, const SceneCatalog& catalog,
                     const Camera& camera) {
  gl_.BindVertexArray(array_);
  for (const DrawItem& item : items) {
    add(item, catalog, camera);
    if (vertices_.size() >= kVerticesAtOnce) flush();
  }
  flush();
}

void ItemBatch::add(const DrawItem& item, const SceneCatalog& catalog, const Camera& camera) {
  const CatalogMesh& mesh = catalog.meshes()[item.mesh];
  const MeshPart& part = mesh.mesh->parts[item.part];
  const ItemMatrices matrices(item.world, camera);
  const glm::mat4& clip = matrices.clip_from_model;
  const glm::mat4& relative = matrices.relative_from_model;
  const glm::mat3& normal = matrices.normal_from_model;
  const auto base = static_cast<std::uint32_t>(vertices_.size());
  vertices_.resize(vertices_.size() + mesh.mesh->vertices.size());
  Vertex* to = vertices_.data() + base;
  for (const rocinante::Vertex& from : mesh.mesh->vertices) {
    const glm::vec3& p = from.position;
    const glm::vec3& n = from.normal;
    // Column by column, in the order of GLSL's matrix * vector.
    for (int i = 0; i < 4; ++i) {
      to->clip[i] = clip[0][i] * p.x + clip[1][i] * p.y + clip[2][i] * p.z + clip[3][i];
    }
    for (int i = 0; i < 3; ++i) {
      to->from_eye[i] =
          relative[0][i] * p.x + relative[1][i] * p.y + relative[2][i] * p.z + relative[3][i];
      to->normal[i] = normal[0][i] * n.x + normal[1][i] * n.y + normal[2][i] * n.z;
    }
    ++to;
  }
  const std::uint32_t* index = mesh.indices().data() + part.first_index;
  for (std::uint32_t i = 0; i < part.index_count; ++i) indices_.push_back(base + index[i]);
}

void ItemBatch::flush() {
  if (indices_.empty()) return;
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)),
                 vertices_.data(), GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)), indices_.data(),
                 GL_STREAM_DRAW);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_INT, nullptr);
  vertices_.clear();
  indices_.clear();
}

}  // namespace rocinante
