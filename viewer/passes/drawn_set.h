#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/passes/texture_store.h"

namespace rocinante {

/// A draw list with its catalog. Borrowed.
struct DrawnSet {
  const DrawList* list = nullptr;
  const SceneCatalog* catalog = nullptr;
  const MeshBuffers* meshes = nullptr;
  const TextureStore* textures = nullptr;  ///< null: its items have none (collisions)
};

}  // namespace rocinante
