#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "viewer/page/page_file.h"

namespace rocinante {
namespace {

bool isLinkByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/@,:").find(c) != std::string_view::npos;
}

/// As the page's URLSearchParams reads it.
std::string linkWord(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (isLinkByte(c)) {
      safe += c;
    } else {
      safe += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return safe;
}

/// A name of a PATH (docs/rendering.md).
std::string pathWord(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (std::string_view("%/#*").find(c) == std::string_view::npos) {
      word += c;
    } else {
      word += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return word;
}

}  // namespace

std::string pageLink(std::optional<Nanoseconds> moment, std::string_view camera,
                     const Path& select) {
  std::string link;
  const auto add = [&](std::string_view key, std::string_view value) {
    link += fmt::format("{}{}={}", link.empty() ? '#' : '&', key, value);
  };
  if (moment) add("t", secondsText(*moment));
  if (!camera.empty()) add("camera", linkWord(camera));
  if (!select.first.empty()) {
    const std::string path =
        pathWord(select.first) + (select.second.empty() ? "" : "/" + pathWord(select.second));
    add("select", linkWord(path));
  }
  return link;
}

}  // namespace rocinante
