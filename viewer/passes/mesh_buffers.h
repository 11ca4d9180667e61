#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/cull/scene_catalog.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/inputs_hash.h"

namespace rocinante {

/// The meshes of a scene on the GPU, by number: one vertex and one index buffer each, shared by
/// every visual that uses it. Its context must be current whenever it is used or destroyed.
class MeshBuffers {
 public:
  /// Adds the uploaded data to `inputs`.
  MeshBuffers(const GlTable& gl, const SceneCatalog& catalog, InputsHash& inputs);

  /// Appends the indices of coarser versions to the mesh's own, `own`.
  void setDetail(std::size_t number, std::span<const std::uint32_t> own,
                 std::span<const std::uint32_t> coarser);

  void bind(std::size_t number) const { gl_.BindVertexArray(meshes_[number].array); }

 private:
  struct Buffers {
    GlVertexArray array;
    GlBuffer vertices, indices;
    GlBuffer colors;  // 0: none
  };
  void addColors(const std::vector<std::uint32_t>& colors, Buffers& buffers, InputsHash& inputs);

  const GlTable& gl_;
  std::vector<Buffers> meshes_;
};

}  // namespace rocinante
