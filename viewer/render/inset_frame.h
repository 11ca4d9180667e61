#pragma once

#include "viewer/overlay/overlay.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// The border and title of an inset, for an overlay of the whole picture.
void addInsetFrame(Overlay& overlay, const FrameInset& inset, const TextAtlas& atlas);

}  // namespace rocinante
