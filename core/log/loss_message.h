#pragma once

#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/log/log_types.h"

namespace rocinante {

/// The payload of a message on profile::kLossTopic (docs/log-format.md): one JSON object.
std::string lossText(const LossSpan& span);

/// Empty when the payload is not a loss message.
std::optional<LossSpan> parseLoss(ByteView payload);

}  // namespace rocinante
