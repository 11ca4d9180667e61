#include "viewer/passes/mesh_buffers.h"

#include <cstddef>
#include <span>
#include <utility>

namespace rocinante {

MeshBuffers::MeshBuffers(const GlTable& gl, const SceneCatalog& catalog, InputsHash& inputs)
    : gl_(gl) {
  for (const CatalogMesh& entry : catalog.meshes()) {
    const Mesh& mesh = *entry.mesh;
    const auto vertices = std::as_bytes(std::span(mesh.vertices));
    const auto indices = std::as_bytes(std::span(entry.indices()));
    inputs.add(vertices);
    inputs.add(indices);

    Buffers buffers{GlVertexArray(gl_), GlBuffer(gl_), GlBuffer(gl_), {}};
    gl_.BindVertexArray(buffers.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(),
                   GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size()), indices.data(),
                   GL_STATIC_DRAW);
    const auto attribute = [&](GLuint place, GLint components, std::size_t offset) {
      gl_.EnableVertexAttribArray(place);
      gl_.VertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, texture));
    if (!mesh.colors.empty()) addColors(mesh.colors, buffers, inputs);
    meshes_.push_back(std::move(buffers));
  }
  gl_.BindVertexArray(0);
}

void MeshBuffers::addColors(const std::vector<std::uint32_t>& colors, Buffers& buffers,
                            InputsHash& inputs) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(colors.size() * 4);
  for (const std::uint32_t color : colors) {
    for (const int shift : {24, 16, 8, 0})
      bytes.push_back(static_cast<std::uint8_t>(color >> shift));
  }
  inputs.add(std::as_bytes(std::span(bytes)));
  buffers.colors = GlBuffer(gl_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers.colors);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                 GL_STATIC_DRAW);
  gl_.EnableVertexAttribArray(3);
  gl_.VertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
}

void MeshBuffers::setDetail(std::size_t number, std::span<const std::uint32_t> own,
                            std::span<const std::uint32_t> coarser) {
  if (coarser.empty()) return;
  const auto bytes = [](std::span<const std::uint32_t> indices) {
    return static_cast<GLsizeiptr>(indices.size_bytes());
  };
  gl_.BindVertexArray(meshes_[number].array);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(own) + bytes(coarser), nullptr, GL_STATIC_DRAW);
  gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, bytes(own), own.data());
  gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, bytes(own), bytes(coarser), coarser.data());
  gl_.BindVertexArray(0);
}

}  // namespace rocinante
