#include "player/source/joystick_drive.h"

#include <algorithm>
#include <cmath>
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

// linux/joystick.h
constexpr std::uint8_t kButton = 0x01;
constexpr std::uint8_t kAxis = 0x02;
constexpr std::uint8_t kInitial = 0x80;

/// A stick that is let go rests near its middle, not in it.
constexpr double kDeadZone = 0.05;

/// -1 to 1, and 0 in the dead zone, without a step at its edge.
double deflection(std::int16_t value) {
  const double whole = std::clamp(value / 32767.0, -1.0, 1.0);
  const double beyond = (std::abs(whole) - kDeadZone) / (1 - kDeadZone);
  return beyond <= 0 ? 0 : std::copysign(beyond, whole);
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

std::optional<JoystickEvent> JoystickEvent::read(std::span<const std::byte, kBytes> bytes) {
  const auto byte = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
  JoystickEvent event;
  event.time_ms = byte(0) | byte(1) << 8U | byte(2) << 16U | byte(3) << 24U;
  event.value = static_cast<std::int16_t>(static_cast<std::uint16_t>(byte(4) | byte(5) << 8U));
  const auto type = static_cast<std::uint8_t>(byte(6));
  event.initial = (type & kInitial) != 0;
  switch (type & ~kInitial) {
    case kButton:
      event.control = JoystickBinding::Control::button;
      break;
    case kAxis:
      event.control = JoystickBinding::Control::axis;
      break;
    default:
      return std::nullopt;
  }
  event.number = static_cast<std::uint8_t>(byte(7));
  return event;
}

double JoystickDrive::Joint::speed() const {
  double sum = 0;
  for (const auto& [binding, speed] : speeds) sum += speed;
  return sum;
}

double JoystickDrive::Joint::at(Nanoseconds now) const {
  const double seconds = static_cast<double>((now - since).count()) / 1e9;
  return std::clamp(base + speed() * seconds, low, high);
}

JoystickDrive::JoystickDrive(JoystickMap map) : map_(std::move(map)) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const JoystickMap::Device& device : map_.devices) {
    joints_.emplace_back(device.joints.size(), Joint{0, {}, {}, -kInfinity, kInfinity});
  }
  for (const JoystickBinding& binding : map_.bindings) {
    if (binding.effect == JoystickBinding::Effect::event) continue;
    Joint& joint = joints_[binding.device][binding.joint];
    joint.low = std::max(joint.low, binding.low);
    joint.high = std::min(joint.high, binding.high);
    joint.base = binding.effect == JoystickBinding::Effect::position
                     ? (binding.low + binding.high) / 2
                     : joint.base;
  }
  for (auto& device : joints_) {
    for (Joint& joint : device) {
      joint.high = std::max(joint.high, joint.low);
      joint.base = std::clamp(joint.base, joint.low, joint.high);
    }
  }
}

void JoystickDrive::apply(const JoystickEvent& event, Nanoseconds at) {
  for (std::size_t i = 0; i < map_.bindings.size(); ++i) {
    const JoystickBinding& binding = map_.bindings[i];
    if (binding.control != event.control || binding.number != event.number) continue;
    if (binding.effect == JoystickBinding::Effect::event) {
      if (event.value != 0 && !event.initial) pressed_.push_back(i);
      continue;
    }
    const bool is_axis = binding.control == JoystickBinding::Control::axis;
    const double share = is_axis ? deflection(event.value) : (event.value != 0 ? 1.0 : 0.0);
    Joint& joint = joints_[binding.device][binding.joint];
    joint.base = joint.at(at);
    joint.since = at;
    if (binding.effect == JoystickBinding::Effect::position) {
      const double part = is_axis ? (share + 1) / 2 : share;
      joint.base =
          std::clamp(binding.low + (binding.high - binding.low) * part, joint.low, joint.high);
      continue;
    }
    const auto known = std::find_if(joint.speeds.begin(), joint.speeds.end(),
                                    [&](const auto& speed) { return speed.first == i; });
    if (known == joint.speeds.end()) {
      joint.speeds.emplace_back(i, binding.rate * share);
    } else {
      known->second = binding.rate * share;
    }
  }
}

void JoystickDrive::positionsAt(Nanoseconds now, std::size_t device,
                                std::vector<double>& positions) const {
  positions.clear();
  for (const Joint& joint : joints_[device]) positions.push_back(joint.at(now));
}

bool JoystickDrive::moves() const {
  for (const auto& device : joints_) {
    for (const Joint& joint : device) {
      if (joint.speed() != 0) return true;
    }
  }
  return false;
}

std::vector<std::string_view> JoystickDrive::takePressed() {
  std::vector<std::string_view> texts;
  for (const std::size_t binding : pressed_) texts.push_back(map_.bindings[binding].text);
  pressed_.clear();
  return texts;
}

}  // namespace rocinante
