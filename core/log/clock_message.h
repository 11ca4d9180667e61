#pragma once

#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace rocinante {

/// A step of the recorder's wall clock: a message on profile::kClockTopic (docs/log-format.md).
struct ClockStep {
  LogTime at;        ///< on the session's time line: when it was noticed
  Nanoseconds step;  ///< positive: the wall clock was set forward
};

/// The payload: one JSON object.
std::string clockStepText(const ClockStep& step);

/// Empty when the payload is not a clock step.
std::optional<ClockStep> parseClockStep(ByteView payload);

/// The payload with its time moved by `shift`, other keys kept. Empty when it is not a clock step
/// or its time would leave the range of LogTime.
std::optional<std::string> shiftedClockText(ByteView payload, Nanoseconds shift);

}  // namespace rocinante
