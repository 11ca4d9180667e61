#include "viewer/picture/picture_size.h"

#include <charconv>
#include <cstddef>
#include <string_view>

namespace rocinante {

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
