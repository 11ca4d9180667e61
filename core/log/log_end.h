#pragma once

#include <cstdint>
#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// True when MCAP's magic is at that place of the file: a log begins and ends with it.
bool magicAt(ByteView file, std::uint64_t position);

/// What the bytes from `end` are, which follow a closed log. Channels of another log may use the
/// same numbers, so they are not read as part of this one.
std::string trailingText(ByteView file, std::uint64_t end);

}  // namespace rocinante
