#pragma once

#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// The levels below `full`, each half as large (rounded down, at least 1), down to 1 x 1. Made with
/// integers only, by a box filter in linear light with colours weighted by opacity, so that they
/// are the same on every CPU; mipmaps of drivers differ (docs/rendering.md).
std::vector<Picture> mipmapsOf(const Picture& full);

/// The next level.
Picture halved(const Picture& picture);

}  // namespace rocinante
