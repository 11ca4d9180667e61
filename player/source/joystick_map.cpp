#include "player/source/joystick_map.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

#include "core/packet/text_number.h"

namespace rocinante {
namespace {

Error refused(const char* what, std::string_view entry) {
  return {ErrorKind::bad_argument, what, std::string(entry)};
}

std::optional<double> numberOf(std::string_view text) {
  const char* at = text.data();
  const char* const end = at + text.size();
  double number = 0;
  if (!readNumber(at, end, number) || at != end) return std::nullopt;
  return number;
}

/// Everything before `mark`, which is taken with it; all of `text` without one.
std::string_view takeUntil(std::string_view& text, std::string_view mark) {
  const std::size_t cut = text.find(mark);
  const std::string_view head = text.substr(0, cut);
  text = cut == std::string_view::npos ? std::string_view() : text.substr(cut + mark.size());
  return head;
}

bool readControl(std::string_view text, JoystickBinding& binding) {
  if (text.starts_with("axis")) {
    binding.control = JoystickBinding::Control::axis;
    text.remove_prefix(4);
  } else if (text.starts_with("button")) {
    binding.control = JoystickBinding::Control::button;
    text.remove_prefix(6);
  } else {
    return false;
  }
  const auto number = readUnsigned(text);
  if (!number || *number > 255) return false;
  binding.number = static_cast<std::uint8_t>(*number);
  return true;
}

bool readBounds(std::string_view text, JoystickBinding& binding) {
  if (text.find("..") == std::string_view::npos) return false;
  const auto low = numberOf(takeUntil(text, ".."));
  const auto high = numberOf(text);
  if (!low || !high || *low >= *high) return false;
  binding.low = *low;
  binding.high = *high;
  return true;
}

/// `0.5/s`, `0.5/s:-1..1` or `-1..1`.
bool readMotion(std::string_view text, JoystickBinding& binding) {
  std::string_view first = takeUntil(text, ":");
  if (!first.ends_with("/s")) {
    binding.effect = JoystickBinding::Effect::position;
    return text.empty() && readBounds(first, binding);
  }
  first.remove_suffix(2);
  const auto rate = numberOf(first);
  if (!rate || *rate == 0) return false;
  binding.effect = JoystickBinding::Effect::jog;
  binding.rate = *rate;
  binding.low = -std::numeric_limits<double>::infinity();
  binding.high = std::numeric_limits<double>::infinity();
  return text.empty() || readBounds(text, binding);
}

/// The place of `joint` of `device` in the map, new or known.
void place(JoystickMap& map, std::string_view device, std::string_view joint,
           JoystickBinding& binding) {
  auto at = std::find_if(map.devices.begin(), map.devices.end(),
                         [&](const JoystickMap::Device& known) { return known.name == device; });
  if (at == map.devices.end()) at = map.devices.insert(at, {std::string(device), {}});
  binding.device = static_cast<std::size_t>(at - map.devices.begin());
  const auto known = std::find(at->joints.begin(), at->joints.end(), joint);
  binding.joint = static_cast<std::size_t>(known - at->joints.begin());
  if (known == at->joints.end()) at->joints.emplace_back(joint);
}

}  // namespace

Result<JoystickMap> readJoystickMap(const std::vector<std::string>& entries) {
  JoystickMap map;
  for (const std::string& entry : entries) {
    std::string_view text = entry;
    JoystickBinding binding;
    if (!readControl(takeUntil(text, "="), binding)) {
      return refused("--map takes axisN=... or buttonN=..., N from 0 to 255", entry);
    }
    for (const JoystickBinding& other : map.bindings) {
      if (other.control == binding.control && other.number == binding.number) {
        return refused("--map names an axis or a button twice", entry);
      }
    }
    const std::string_view target = takeUntil(text, ":");
    if (target == "event") {
      if (binding.control == JoystickBinding::Control::axis || text.empty()) {
        return refused("an event has a text and belongs to a button: button0=event:TEXT", entry);
      }
      binding.effect = JoystickBinding::Effect::event;
      binding.text = text;
      map.bindings.push_back(std::move(binding));
      continue;
    }
    const std::size_t point = target.find('.');
    if (point == std::string_view::npos || point == 0 || point + 1 == target.size()) {
      return refused("--map moves a DEVICE.JOINT", entry);
    }
    if (!readMotion(text, binding)) {
      return refused("--map takes RATE/s, RATE/s:LOW..HIGH or LOW..HIGH after the joint", entry);
    }
    place(map, target.substr(0, point), target.substr(point + 1), binding);
    map.bindings.push_back(std::move(binding));
  }
  if (map.devices.empty()) return refused("--joystick needs a joint to move: --map", "");
  return map;
}

}  // namespace rocinante
