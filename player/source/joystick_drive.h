#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

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

/// One event of Linux' joystick interface (`js_event` of linux/joystick.h: 8 bytes, the processor's
/// byte order, here little-endian).
struct JoystickEvent {
  static constexpr std::size_t kBytes = 8;

  std::uint32_t time_ms = 0;  ///< of a clock of the driver's
  std::int16_t value = 0;     ///< axis: -32767 to 32767; button: 0 or 1
  JoystickBinding::Control control{};
  bool initial = false;  ///< tells how things stood when the device was opened
  std::uint8_t number = 0;

  /// Empty when the bytes are no such event.
  static std::optional<JoystickEvent> read(std::span<const std::byte, kBytes> bytes);
};

/// What a joystick's events make of the joints that it moves. Pure: time comes in with its
/// arguments, in nanoseconds on any line that does not go back.
class JoystickDrive {
 public:
  /// Jogged joints begin at 0 or, where that is out of bounds, at the nearest bound; positions in
  /// the middle.
  explicit JoystickDrive(JoystickMap map);

  const JoystickMap& map() const { return map_; }

  void apply(const JoystickEvent& event, Nanoseconds at);

  /// Positions of a device's joints at `now`, in the order of the map.
  void positionsAt(Nanoseconds now, std::size_t device, std::vector<double>& positions) const;
  /// A joint is moving: positions differ from moment to moment without any event.
  bool moves() const;
  /// Texts of the events whose buttons were pressed since the last call; valid as long as this.
  std::vector<std::string_view> takePressed();

 private:
  struct Joint {
    double base = 0;  ///< at `since`
    Nanoseconds since{};
    /// What each jogging axis and button adds, rad/s or m/s; they add up.
    std::vector<std::pair<std::size_t, double>> speeds;  ///< by binding
    double low = 0, high = 0;

    double speed() const;
    double at(Nanoseconds now) const;
  };

  JoystickMap map_;
  std::vector<std::vector<Joint>> joints_;  ///< by device and joint
  std::vector<std::size_t> pressed_;        ///< bindings
};

}  // namespace rocinante
