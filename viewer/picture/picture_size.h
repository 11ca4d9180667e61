#pragma once

#include <string>
#include <utility>

#include "core/base/result.h"

namespace rocinante {

/// Width and height of "640x480", each from 1 to 16384. bad_argument for anything else.
Result<std::pair<int, int>> parsePictureSize(const std::string& text);

}  // namespace rocinante
