#pragma once

#include "viewer/render/draw_list.h"
#include "viewer/render/gl_table.h"

namespace rocinante {

/// Draws the triangles of one item with whatever program is in use: those that are seen from their
/// front alone with culling, which is off before and after. Its mesh must be bound
/// (MeshBuffers::bind).
void drawTriangles(const GlTable& gl, const DrawItem& item, const SceneCatalog& catalog);

}  // namespace rocinante
