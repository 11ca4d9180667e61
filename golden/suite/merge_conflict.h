#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// damaged, with the line, when the text has a git conflict marker of an unfinished merge. `what`
/// is put before " holds", `advice` at the end.
std::optional<Error> mergeConflictIn(std::string_view text, const std::string& file,
                                     std::string_view what, std::string_view advice);

}  // namespace rocinante
