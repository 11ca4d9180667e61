#pragma once

#include <string_view>

namespace rocinante {

/// Names the code of this build that reads cells and decodes pictures: a hash of its libraries, so
/// that a cell which other code has read is never taken for one of this build's.
std::string_view cellReaderId();

}  // namespace rocinante
