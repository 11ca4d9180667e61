#pragma once

#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// The orientation that EXIF metadata (a TIFF header and its first directory) asks to show a
/// picture in, 1 to 8; 1, as it is stored, when it has none or is broken.
int exifOrientation(ByteView exif);

/// "as stored", "turned by 180 degrees": what a viewer does with a picture of that orientation.
std::string orientationText(int orientation);

}  // namespace rocinante
