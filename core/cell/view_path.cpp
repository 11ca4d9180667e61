#include "core/cell/view_path.h"

#include <algorithm>
#include <optional>

#include "core/base/hex_digit.h"
#include "core/base/pattern.h"

namespace rocinante {
namespace {

std::optional<std::string> decodedName(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    const std::optional<char> byte = percentByte(text, i);
    if (!byte) return std::nullopt;
    name += *byte;
    i += 2;
  }
  if (name.empty()) return std::nullopt;
  return name;
}

}  // namespace

Result<ViewPath> parseViewPath(std::string_view text) {
  const auto bad = [&] {
    return Error{
        ErrorKind::bad_argument,
        "`" + std::string(text) +
            "` is not a PATH: DEVICE, DEVICE/LINK or layer/NAME (#GROUP behind it for a part)",
        {}};
  };
  ViewPath wanted;
  std::string_view names = text;
  if (const std::size_t hash = text.find('#'); hash != std::string_view::npos) {
    const auto group = decodedName(text.substr(hash + 1));
    if (!group) return bad();
    wanted.group = *group;
    wanted.has_group = true;
    names = text.substr(0, hash);
  }
  const std::size_t slash = names.find('/');
  const auto first = decodedName(names.substr(0, slash));
  if (!first) return bad();
  std::optional<std::string> second;
  if (slash != std::string_view::npos) {
    second = decodedName(names.substr(slash + 1));
    if (!second) return bad();
  }
  const bool is_layer = *first == "layer";
  if (is_layer && (!second || wanted.has_group)) return bad();
  wanted.all_devices = names.substr(0, slash) == "*";
  wanted.path = {is_layer, wanted.all_devices ? std::string() : *first, second.value_or("")};
  return wanted;
}

bool ViewPath::namesLink(const PosedDevice& device, std::size_t link) const {
  if (has_group) return false;
  if (path.is_layer) return device.inLayer(path.second, link);
  if (!all_devices && path.first != device.name) return false;
  return path.second.empty() || device.model->links[link].name == path.second;
}

bool ViewPath::namesPartByLayer(const PosedDevice& device, std::size_t link,
                                std::string_view part_group) const {
  if (!path.is_layer || !device.has_parts) return false;
  return std::ranges::any_of(device.shares, [&](const PosedShare& share) {
    return share.layer == path.second && share.holdsPart(link, part_group);
  });
}

bool ViewPath::namesPart(const PosedDevice& device, std::size_t link,
                         std::string_view part_group) const {
  if (!has_group) return namesLink(device, link) || namesPartByLayer(device, link, part_group);
  if (!all_devices && path.first != device.name) return false;
  if (!path.second.empty() && device.model->links[link].name != path.second) return false;
  return patternMatches(group, part_group);
}

}  // namespace rocinante
