#pragma once

#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// What is said of a file that is no log: that it is empty, or does not begin as a log does, and
/// where its first bytes are those of a capture, an archive or a bag, what it is and what helps.
std::string notALog(ByteView file);

}  // namespace rocinante
