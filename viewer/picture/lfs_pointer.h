#pragma once

#include "core/base/bytes.h"

namespace rocinante {

/// True for the pointer file that Git LFS leaves in place of a picture.
bool isLfsPointer(ByteView bytes);

}  // namespace rocinante
