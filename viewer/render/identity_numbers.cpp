#include "viewer/render/identity_numbers.h"

#include <algorithm>
#include <map>

namespace rocinante {

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
