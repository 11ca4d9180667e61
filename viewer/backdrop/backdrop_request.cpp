#include "viewer/backdrop/backdrop_request.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace rocinante {
namespace {

/// The time between two pictures at that many a second; 0 when the text says none.
Nanoseconds periodOf(std::string_view text) {
  double rate = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), rate);
  const bool sound = fault == std::errc{} && stop == text.data() + text.size();
  if (!sound || !(rate >= 0.001 && rate <= 1000)) return Nanoseconds(0);
  return Nanoseconds(static_cast<std::int64_t>(std::llround(1e9 / rate)));
}

}  // namespace

Result<BackdropRequest> parseBackdrop(std::string_view text) {
  BackdropRequest request;
  while (true) {
    const std::size_t comma = text.rfind(',');
    if (comma == std::string_view::npos) break;
    const std::string_view word = text.substr(comma + 1);
    if (word.starts_with("camera=")) {
      request.camera = word.substr(7);
    } else if (word.starts_with("fps=")) {
      request.period = periodOf(word.substr(4));
      if (request.period == Nanoseconds(0)) {
        return Error{ErrorKind::bad_argument, "the pictures a second must be 0.001 to 1000",
                     std::string(word)};
      }
    } else {
      break;
    }
    text = text.substr(0, comma);
  }
  request.file = text;
  if (text.empty()) {
    return Error{ErrorKind::bad_argument, "a backdrop needs a picture, a folder or a video", {}};
  }
  return request;
}

std::string backdropText(const BackdropRequest& request, const std::string& camera) {
  std::string text = request.file.string();
  if (request.period > Nanoseconds(0)) {
    text += fmt::format(",fps={}", 1e9 / static_cast<double>(request.period.count()));
  }
  return text + ",camera=" + camera;
}

}  // namespace rocinante
