#include "viewer/render/identity_frame.h"

#include <algorithm>
#include <set>

#include "core/base/hash.h"

namespace rocinante {
namespace {

/// Minimum of a component, to distinguish colours from black.
constexpr std::uint32_t kDarkest = 40;

std::uint32_t colorOfName(const IdentityName& name, unsigned attempt) {
  // Names have no zero byte, so the text is unique.
  std::string text = name.device + '\0' + name.link;
  if (attempt > 0) text += '\0' + std::to_string(attempt);
  const auto digest = xxh3(bytesOf(text));
  std::uint32_t rgba = 0;
  for (std::size_t component = 0; component < 3; ++component) {
    const auto byte = std::to_integer<std::uint32_t>(digest[component]);
    rgba = rgba << 8U | (kDarkest + byte * (255 - kDarkest) / 255);
  }
  return rgba << 8U | 0xFFU;
}

}  // namespace

std::vector<IdentityExtent> extentsOf(const IdentityFrame& frame) {
  std::vector<IdentityExtent> extents(frame.names.size());
  std::size_t place = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const std::uint32_t id = frame.ids[place++];
      if (id == 0) continue;
      IdentityExtent& extent = extents[id - 1];
      if (extent.pixels++ == 0) extent = {1, x, y, x + 1, y + 1};
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x + 1);
      extent.bottom = y + 1;
    }
  }
  return extents;
}

std::vector<std::uint32_t> identityColors(const std::vector<IdentityName>& names) {
  std::vector<std::uint32_t> colors;
  std::set<std::uint32_t> taken;
  for (const IdentityName& name : names) {
    unsigned attempt = 0;
    std::uint32_t color = colorOfName(name, attempt);
    while (!taken.insert(color).second) color = colorOfName(name, ++attempt);
    colors.push_back(color);
  }
  return colors;
}

Picture identityPicture(const IdentityFrame& frame) {
  const std::vector<std::uint32_t> colors = identityColors(frame.names);
  Picture picture{frame.width, frame.height, {}};
  picture.rgba.reserve(frame.ids.size() * 4);
  for (const std::uint32_t id : frame.ids) {
    const std::uint32_t rgba = id == 0 ? 0x000000FFU : colors[id - 1];
    for (const int shift : {24, 16, 8, 0}) {
      picture.rgba.push_back(static_cast<std::uint8_t>(rgba >> shift));
    }
  }
  return picture;
}

}  // namespace rocinante
