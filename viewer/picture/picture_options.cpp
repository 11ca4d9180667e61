#include "viewer/picture/picture_options.h"

#include <charconv>
#include <cstddef>
#include <string_view>

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

Result<std::pair<int, int>> parsePictureSize(const std::string& text) {
  const auto side = [](std::string_view digits) {
    int value = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = fault == std::errc() && end == digits.data() + digits.size();
    return whole && value >= 1 && value <= 16384 ? value : 0;
  };
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const int width = side(std::string_view(text).substr(0, cross));
    const int height = side(std::string_view(text).substr(cross + 1));
    if (width > 0 && height > 0) return std::pair(width, height);
  }
  return Error{ErrorKind::bad_argument,
               "`" + text + "` is not a size: use WIDTHxHEIGHT in pixels, as 640x480",
               {}};
}

}  // namespace rocinante
