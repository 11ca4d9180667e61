#pragma once

#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/log/log_types.h"

namespace rocinante {

inline constexpr std::string_view kLossTopic = "/rocinante/loss";
inline constexpr std::string_view kLossEncoding = "json";

/// The payload of a message on /rocinante/loss (docs/log-format.md): one JSON object.
std::string lossText(const LossSpan& span);

/// Empty when the payload is no loss message.
std::optional<LossSpan> parseLoss(ByteView payload);

}  // namespace rocinante
