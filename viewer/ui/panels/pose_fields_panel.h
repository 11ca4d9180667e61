#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the pose of the selected device as fields to type into, in the space in which the cell
/// says it; nothing unless hasPoseFields(). Those of a device that cannot be moved by hand take no
/// text and say why.
void drawPoseFields(ViewModel& model);

/// In every frame after the place of the fields, drawn or not: a number whose field has lost the
/// keyboard is taken, or put back by Esc.
void settlePoseFields(ViewModel& model);

}  // namespace rocinante
