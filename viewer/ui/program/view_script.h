#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// One line of a script that drives the window in place of a person (docs/programs/view.md): a
/// command and its words. Commands and the count of their words are checked when it is read.
struct ViewCommand {
  std::string name;
  std::vector<std::string> words;
  int line = 0;
};

/// One command a line, words separated by spaces, `#` to the end of the line is left out. `name` is
/// for faults: bad_argument with NAME:LINE.
Result<std::vector<ViewCommand>> parseViewScript(std::string_view text, std::string_view name);

}  // namespace rocinante
