#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "player/source/source.h"

namespace rocinante {

struct JoystickSourceOptions {
  std::filesystem::path device;                   ///< /dev/input/jsN, or a file of its events
  std::vector<std::string> map;                   ///< as readJoystickMap() takes it
  std::string source;                             ///< SOURCE; empty: the name of the first device
  Nanoseconds restate = std::chrono::seconds(2);  ///< 0: never
};

/// Moves joints by hand: what the joystick says as a live source, 60 times a second while a joint
/// moves and otherwise only what changed, until stopped. A file of events is sent with its events'
/// own spacing and ends after the last. A joystick that is unplugged ends it with `damage` in the
/// report. Refuses a faulty map before the first datagram.
Result<PlayReport> sendJoystick(const JoystickSourceOptions& joystick, const SourceOptions& options,
                                const SendSurroundings& surroundings);

}  // namespace rocinante
