#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Whether the name's ending is .png or .PNG.
bool isPngName(const std::filesystem::path& path);

/// unsupported, with the reason, when encodePicture() has no format for the ending of this name:
/// for asking before the picture is drawn.
Status mayEncodePicture(const std::filesystem::path& path);

/// Encodes in the format that the name's ending means: PNG by encodePng(), all else by the
/// OpenImageIO module. JPEG and WebP lose; formats of linear light (.exr, .hdr) have that of the
/// picture's values, others the values themselves; alpha is kept where the format has it and a
/// pixel is not opaque. Any thread.
Result<Bytes> encodePicture(const std::filesystem::path& path, const Picture& picture);

/// Width and height of "640x480", each from 1 to 16384. bad_argument for anything else.
Result<std::pair<int, int>> parsePictureSize(const std::string& text);

}  // namespace rocinante
