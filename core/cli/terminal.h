#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rocinante::cli {

/// What standard output is, for programs that lay text out for people.
struct OutputTerminal {
  bool is_terminal = false;
  bool color = false;       ///< a terminal, NO_COLOR is unset and TERM is not "dumb"
  bool unicode = false;     ///< a terminal, and the locale says UTF-8
  std::size_t columns = 0;  ///< of the terminal; 0: none, or not known
};
OutputTerminal outputTerminal();

/// `text` as the one line that a terminal shows again and again: in place of the one before, and
/// cut by the terminal itself where it is too narrow, however it is resized.
std::string statusLine(std::string_view text);

}  // namespace rocinante::cli
