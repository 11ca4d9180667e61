#pragma once

#include <string>
#include <vector>

#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

/// The shown insets with their places in a window's picture of that size, by fitInsets(); the
/// places are kept in the model too. An inset with an unknown camera or that repeats the main view
/// is left out. `fitted` must be prepared.
std::vector<FrameInset> frameInsets(ViewModel& model, FittedCameras& fitted, int width, int height,
                                    double scale);

/// Moves the kept places to where they are in a picture of that size, which is yet to be drawn:
/// what the mouse meets in between is there already.
void replaceInsets(ViewModel& model, int width, int height, double scale);

/// Those that have no room in such a picture.
std::vector<InsetTab> insetTabs(ViewModel& model, int width, int height, double scale);
/// Gives the inset room before others.
void openInset(ViewModel& model, std::size_t number);

/// Sets what the model says of a picture of it of the terms' size and scale, the session beside
/// left out: looks, insets, and what is hidden and shown. All insets as the cell has them are not
/// said.
void setTerms(ViewModel& model, PictureTerms& terms);

/// So near its inner corner an inset is held by that, at scale 1.
constexpr double kInsetGripPx = 18;

/// The inset of the last frame at that pixel, to be dragged: by the corner towards the picture's
/// middle, within `reach_px`, it changes its size, else its place. The topmost counts.
std::optional<InsetDrag> grabInset(const ViewModel& model, double x, double y, double reach_px);
/// The mouse is there now, in a picture of that size.
void dragInset(ViewModel& model, const InsetDrag& drag, double x, double y, int width, int height,
               double scale);
/// The inset shows what the picture shows, and the picture what the inset shows. bad_argument for
/// one that the last frame does not have.
Status swapInset(ViewModel& model, std::size_t number);

}  // namespace rocinante
