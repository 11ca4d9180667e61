#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "player/source/joystick_map.h"

namespace rocinante {

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
