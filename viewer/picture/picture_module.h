#pragma once

#include <filesystem>

#include "viewer/picture/fine_picture.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Reads a picture with the OpenImageIO module, which is searched for once, on the first call: in
/// the folder ROCINANTE_MODULES, else in ../lib beside the program (a build folder) and in the
/// installed module folder. unsupported, with the reason, when it cannot be used.
Result<Picture> readByModule(const std::filesystem::path& path, std::int64_t max_pixels);
Result<FinePicture> readFineByModule(const std::filesystem::path& path, std::int64_t max_pixels);
/// The same from bytes; `name` is used in messages.
Result<Picture> decodeByModule(ByteView bytes, const std::string& name, std::int64_t max_pixels);

}  // namespace rocinante
