#include <fstream>

#include "viewer/picture/picture.h"
#include "viewer/picture/picture_module.h"

namespace rocinante {

Result<Picture> readPicture(const std::filesystem::path& path, std::int64_t max_pixels) {
  std::ifstream file(path, std::ios::binary);
  char first[8] = {};
  if (!file.read(first, sizeof first)) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
      return Error{ErrorKind::not_found, "the picture does not exist", path.string()};
    }
    return Error{ErrorKind::unreadable, "is no picture that can be read", path.string()};
  }
  file.close();
  const bool png = std::string_view(first, sizeof first) == "\x89PNG\r\n\x1A\n";
  return png ? readPng(path, max_pixels) : readByModule(path, max_pixels);
}

Result<Picture> decodePicture(ByteView bytes, const std::string& name, std::int64_t max_pixels) {
  const bool png = textOf(bytes).starts_with("\x89PNG\r\n\x1A\n");
  return png ? decodePng(bytes, name, max_pixels) : decodeByModule(bytes, name, max_pixels);
}

}  // namespace rocinante
