#include "viewer/render/view_choice.h"

#include <optional>

namespace rocinante {
namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Lenient, because people type these: any byte may stand for itself.
std::optional<std::string> decoded(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hexDigit(text[i + 1]);
    const int low = hexDigit(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    name += static_cast<char>(high * 16 + low);
    i += 2;
  }
  if (name.empty()) return std::nullopt;
  return name;
}

Result<Path> parsePath(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto first = decoded(std::string_view(text).substr(0, slash));
  const bool has_second = slash != std::string::npos;
  const auto second = has_second ? decoded(std::string_view(text).substr(slash + 1))
                                 : std::optional<std::string>("");
  if (!first || !second || (*first == "layer" && !has_second)) {
    return Error{ErrorKind::bad_argument,
                 "`" + text + "` is no PATH: DEVICE, DEVICE/LINK or layer/NAME",
                 {}};
  }
  return Path{*first == "layer", *first, *second};
}

}  // namespace

Result<ViewChoice> ViewChoice::make(const std::vector<std::string>& hide,
                                    const std::vector<std::string>& show) {
  ViewChoice choice;
  for (const auto* list : {&show, &hide}) {
    for (const std::string& text : *list) {
      const Result<Path> path = parsePath(text);
      if (!path) return path.error();
      choice.visible_[*path] = list == &show;
    }
  }
  return choice;
}

bool ViewChoice::linkVisible(const PosedDevice& device, std::size_t link) const {
  if (!visible_.empty()) {
    const Path device_path{false, device.name, {}};
    const Path link_path{false, device.name, device.model->links[link].name};
    const Path layer_path{true, "layer", device.layer};
    for (const Path* path : {&link_path, &device_path, &layer_path}) {
      const auto found = visible_.find(*path);
      if (found != visible_.end()) return found->second;
    }
  }
  return device.visible && device.link_visible[link];
}

bool ViewChoice::layerVisible(std::string_view layer) const {
  const auto found = visible_.find(Path{true, "layer", std::string(layer)});
  return found == visible_.end() || found->second;
}

}  // namespace rocinante
