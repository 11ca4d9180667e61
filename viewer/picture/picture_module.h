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

/// A picture of one number a pixel, rows top to bottom.
struct MeasuredPicture {
  int width = 0, height = 0;
  std::span<const float> floats;           ///< or
  std::span<const std::uint32_t> numbers;  ///< these
  std::string channel;
  /// Names and values by turns, which the file carries where its format can.
  std::vector<std::string> text;
};

/// Encodes in the format that the ending of `name` means. unsupported when none of that ending is
/// written, or when the module cannot be used.
Result<Bytes> encodeByModule(const std::string& name, const Picture& picture);
Result<Bytes> encodeByModule(const std::string& name, const MeasuredPicture& picture);
/// Whether encodeByModule() could.
Status mayEncodeByModule(const std::string& name);

}  // namespace rocinante
