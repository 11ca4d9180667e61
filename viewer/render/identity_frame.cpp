#include "viewer/render/identity_frame.h"

#include <algorithm>
#include <map>
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

IdentityNumbers::IdentityNumbers(const PosedScene& scene) : scene_(scene) {
  for (const PosedDevice& device : scene.devices) {
    first_of_device_.push_back(first_drawing_);
    if (device.model != nullptr) {
      first_drawing_ += static_cast<std::uint32_t>(device.model->links.size());
    }
  }
}

std::vector<std::uint32_t> IdentityNumbers::ofVertices(const Overlay& overlay) const {
  std::vector<std::uint32_t> numbers = overlay.owners();
  for (std::uint32_t& number : numbers) {
    if (number > 0) number += first_drawing_ - 1;
  }
  return numbers;
}

IdentityName IdentityNumbers::nameOf(std::uint32_t number) const {
  if (number >= first_drawing_) {
    const PosedDrawing& drawing = scene_.drawings[number - first_drawing_];
    return {"drawing", drawing.source + "/" + drawing.id};
  }
  // The last device that begins at or before the number: a device without links begins where the
  // next one does.
  const auto behind = std::upper_bound(first_of_device_.begin(), first_of_device_.end(), number);
  const auto device = static_cast<std::size_t>(behind - first_of_device_.begin()) - 1;
  const PosedDevice& posed = scene_.devices[device];
  return {posed.name, posed.model->links[number - first_of_device_[device]].name};
}

IdentityFrame IdentityNumbers::frame(std::vector<std::uint32_t> numbers, int width,
                                     int height) const {
  std::map<std::uint32_t, std::uint32_t> compact;
  std::uint32_t last = 0;
  for (const std::uint32_t number : numbers) {
    if (number != last && number != 0) compact.emplace(number, 0);
    last = number;
  }
  IdentityFrame frame{width, height, std::move(numbers), {}};
  for (auto& [number, id] : compact) {
    frame.names.push_back(nameOf(number));
    id = static_cast<std::uint32_t>(frame.names.size());
  }
  std::uint32_t last_id = 0;
  last = 0;
  for (std::uint32_t& number : frame.ids) {
    if (number != last) {
      last = number;
      last_id = number == 0 ? 0 : compact.at(number);
    }
    number = last_id;
  }
  return frame;
}

}  // namespace rocinante
