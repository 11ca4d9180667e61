#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/passes/mesh_buffers.h"

namespace rocinante {

/// A draw list with its catalog. Borrowed.
struct DrawnSet {
  const DrawList* list = nullptr;
  const SceneCatalog* catalog = nullptr;
  const MeshBuffers* meshes = nullptr;
};

}  // namespace rocinante
