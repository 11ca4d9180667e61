#pragma once

#include <string_view>

#include "core/cell/cell.h"
#include "viewer/overlay/overlay.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// An inset of a frame with its place and view. `backdrop_camera`: whose views have the backdrop;
/// empty: there is none.
FrameInset frameInset(const CellInset& inset, const PixelRectangle& part, const CameraView& camera,
                      std::string_view backdrop_camera);

/// The border and title of an inset, for an overlay of the whole picture.
void addInsetFrame(Overlay& overlay, const FrameInset& inset, const TextAtlas& atlas);

}  // namespace rocinante
