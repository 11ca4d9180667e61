#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/plain_text.h"

namespace rocinante {

/// A payload on one line. Lines of packet text are joined by " | "; other payloads are shown as
/// their first 32 bytes in hexadecimal, with the length.
std::string payloadLine(ByteView payload, bool is_text);

}  // namespace rocinante
