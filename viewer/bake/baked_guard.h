#pragma once

#include "core/cell/cell.h"

namespace rocinante {

// What readers of models keep, and those who draw rely on, checked anew for what was baked. Each
// answers the first fault, or null.

/// Indices, parts and materials within their lists, and finite vertices.
const char* faultOfMesh(const Mesh& mesh);
/// One tree of links and joints, updated from its root, without loops of mimics.
const char* faultOfModel(const Model& model);
/// Numbers of devices within their list.
const char* faultOfCell(const Cell& cell);

}  // namespace rocinante
