#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// One line of a script that drives the window (docs/programs/view.md): a command and its words.
/// Commands, their word counts and the times of frames are checked when it is read.
struct ViewCommand {
  std::string name;
  std::vector<std::string> words;
  int line = 0;
  /// Of `frame-at`.
  std::optional<Nanoseconds> at{};
};

/// One command per line, words separated by spaces, `#` begins a comment. bad_argument with
/// NAME:LINE.
Result<std::vector<ViewCommand>> parseViewScript(std::string_view text, std::string_view name);

}  // namespace rocinante
