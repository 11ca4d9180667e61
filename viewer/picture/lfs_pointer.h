#pragma once

#include "core/base/bytes.h"

namespace rocinante {

/// True for the text file that Git LFS leaves where a picture should be.
bool isLfsPointer(ByteView bytes);

}  // namespace rocinante
