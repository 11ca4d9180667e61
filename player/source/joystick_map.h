#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// What one axis or button of a joystick does (docs/programs/source.md).
struct JoystickBinding {
  enum class Control : std::uint8_t { axis, button };
  enum class Effect : std::uint8_t {
    jog,       ///< full deflection moves the joint at `rate`
    position,  ///< the deflection is the joint's place between `low` and `high`
    event      ///< a press says `text`
  };
  Control control{};
  std::uint8_t number = 0;  ///< of the axis or the button, from 0
  Effect effect{};
  std::size_t device = 0, joint = 0;  ///< in JoystickMap::devices
  double rate = 0;                    ///< rad/s or m/s at full deflection; negative: the other way
  double low = 0, high = 0;           ///< rad or m; of a jogged joint without bounds: infinite
  std::string text;                   ///< of an event
};

/// The devices that a joystick moves and what each of its axes and buttons does.
struct JoystickMap {
  struct Device {
    std::string name;
    std::vector<std::string> joints;  ///< in the order of their first mention
  };
  std::vector<Device> devices;
  std::vector<JoystickBinding> bindings;
};

/// Reads entries as docs/programs/source.md has them: `axis0=arm.shoulder:0.5/s:-1.5..1.5`,
/// `axis1=gripper.width:0..0.08`, `button0=event:grasp`. bad_argument with the entry: one that does
/// not read so, an axis or a button named twice, or no entry.
Result<JoystickMap> readJoystickMap(const std::vector<std::string>& entries);

}  // namespace rocinante
