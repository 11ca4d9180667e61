#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/plain_text.h"

namespace rocinante {

/// A payload on one line. Packet text has its lines joined by " | "; other bytes are given in
/// hexadecimal, the first 32 of them, with the length.
std::string payloadLine(ByteView payload, bool is_text);

/// RFC 4648, with padding.
std::string base64Of(ByteView bytes);

}  // namespace rocinante
