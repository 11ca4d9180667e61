#pragma once

#include "viewer/ui/model/panel_places.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Where it stands in that part of the window, in pixels: in a corner that no inset has; empty when
/// it is switched off, or nowhere has room.
std::optional<PixelRectangle> viewCubePlace(ViewModel& model, const PanelRectangle& room);

/// Draws a cube as the scene is seen, in a corner of `room`, the part of the window in pixels that
/// no panel covers: a click on a face, an edge or a corner looks from there, a drag turns the view.
/// Nothing where there is no room for it. It is of the window, not of the picture.
void drawViewCube(ViewModel& model, const PanelRectangle& room);

}  // namespace rocinante
