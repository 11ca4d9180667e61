#include "viewer/picture/picture_encoding.h"

#include "viewer/picture/picture_module.h"

namespace rocinante {

bool isPngName(const std::filesystem::path& path) {
  return path.extension() == ".png" || path.extension() == ".PNG";
}

Status mayEncodePicture(const std::filesystem::path& path) {
  if (path.extension().empty()) {
    return Error{ErrorKind::bad_argument, "the picture's name needs an ending, as .png",
                 path.string()};
  }
  return isPngName(path) ? Status{} : mayEncodeByModule(path.string());
}

Result<Bytes> encodePicture(const std::filesystem::path& path, const Picture& picture) {
  if (!isPngName(path)) return encodeByModule(path.string(), picture);
  Bytes png = encodePng(picture);
  if (png.empty()) return Error{ErrorKind::refused, "not enough memory to encode", path.string()};
  return png;
}

}  // namespace rocinante
