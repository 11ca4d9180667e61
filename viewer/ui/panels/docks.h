/// The edges of the window at which panels stand. Only panels and the program include this.
#pragma once

#include "viewer/ui/model/dock_layout.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// Where everything stands in a window of that size in pixels, `unit` of them to an interface unit.
DockLayout dockLayoutOf(const ViewModel& model, float width, float height, float unit);

/// In a window of that size nothing is looked at any more that has room without it: it yields again
/// when the window becomes smaller. Before dockLayoutOf().
void endNeedlessPeek(ViewModel& model, float width, float height, float unit);

/// The part of the window that the picture gets, in whole pixels.
PixelRectangle picturePart(const DockLayout& layout);

/// Draws what is behind the docked panels, the strips of folded edges and the gutters, and applies
/// the mouse to them: a strip opens its panels, a gutter is dragged, and folds by its handle or by
/// a double click. Before the panels.
void drawDocks(ViewModel& model, const DockLayout& layout);

/// Whether the user has taken the panel off its edge.
bool isFloating(const PanelPlaces& places, const char* panel);

}  // namespace rocinante
