#pragma once

#include "core/base/bytes.h"

namespace rocinante {

/// DejaVu Sans, a TrueType file, as it was on the machine that built us: every picture's text is
/// drawn from these bytes, whatever fonts the machine has that runs us. Lives as long as the
/// process.
ByteView embeddedFont();

}  // namespace rocinante
