#pragma once

#include <filesystem>

#include "viewer/picture/fine_picture.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Reads a picture with the OpenImageIO module, which is looked for once, on the first call: in the
/// folder that ROCINANTE_MODULES names, else in ../lib beside the program (a build folder) and in
/// the installed module folder. unsupported, with the reason, when it cannot be used.
Result<Picture> readByModule(const std::filesystem::path& path, std::int64_t max_pixels);
Result<FinePicture> readFineByModule(const std::filesystem::path& path, std::int64_t max_pixels);
/// The same from bytes; `name` is for the sentence.
Result<Picture> decodeByModule(ByteView bytes, const std::string& name, std::int64_t max_pixels);

}  // namespace rocinante
