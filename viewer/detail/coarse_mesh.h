#pragma once

#include "core/mesh/mesh.h"

namespace rocinante {

/// The mesh with about half of its triangles, `halvings` times, as makeMeshDetail() leaves them
/// out: parts that are small, or would be farther from their surface than a twentieth of their
/// size, keep more. Parts, materials and bounds stay; a primitive shape stays whole. Pure.
Mesh coarseMesh(const Mesh& mesh, int halvings);

}  // namespace rocinante
