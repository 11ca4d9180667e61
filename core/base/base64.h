#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante {

/// RFC 4648, with padding, in one line.
std::string base64Of(ByteView bytes);
/// Empty when `text` is anything else than what base64Of() writes.
std::optional<Bytes> bytesOfBase64(std::string_view text);

}  // namespace rocinante
