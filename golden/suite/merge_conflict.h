#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// damaged, with the line, when git left a conflict in the text: a merge that nobody finished.
/// `what` stands before " holds", `advice` behind it.
std::optional<Error> mergeConflictIn(std::string_view text, const std::string& file,
                                     std::string_view what, std::string_view advice);

}  // namespace rocinante
