#pragma once

#include "core/base/bytes.h"

namespace rocinante {

/// DejaVu Sans, a TrueType file of the build machine: text in every picture is drawn from these
/// bytes, independent of installed fonts. Valid as long as the process.
ByteView embeddedFont();

}  // namespace rocinante
