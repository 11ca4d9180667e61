#pragma once

#include <string>
#include <string_view>

#include "core/bytes.h"

namespace rocinante {

/// True when the bytes are UTF-8 (RFC 3629: no overlong forms, no surrogates).
bool isUtf8(ByteView bytes);

/// Text of a stranger as a terminal may see it: control characters and what is no UTF-8 as \xNN, so
/// that a datagram cannot move the cursor or end a line.
std::string plainText(std::string_view text);

/// A payload on one line. Packet text has its lines joined by " | "; other bytes are given in
/// hexadecimal, the first 32 of them, with the length.
std::string payloadLine(ByteView payload, bool is_text);

/// RFC 4648, with padding.
std::string base64Of(ByteView bytes);

}  // namespace rocinante
