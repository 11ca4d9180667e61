#include "viewer/passes/overlay_buffer.h"

#include <cstddef>

namespace rocinante {

OverlayBuffer::OverlayBuffer(const GlTable& gl) : gl_(gl) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  for (GLuint place = 0; place < 4; ++place) gl_.EnableVertexAttribArray(place);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei kStride = sizeof(OverlayVertex);
  gl_.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(OverlayVertex, clip)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride,
                          offset(offsetof(OverlayVertex, texture)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          offset(offsetof(OverlayVertex, abgr)));
  gl_.VertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, offset(offsetof(OverlayVertex, kind)));
  gl_.BindVertexArray(0);
}

void OverlayBuffer::draw(std::span<const OverlayVertex> vertices) const {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                 GL_STREAM_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace rocinante
