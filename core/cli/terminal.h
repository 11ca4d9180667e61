#pragma once

#include <cstddef>

namespace rocinante::cli {

/// Opens whatever is closed of the first three descriptors, before anything else is opened:
/// otherwise a log or a socket would get the number of standard output, and the program's output
/// would go into it. Descriptors opened here refuse reads and writes, so that a lost report is
/// still noticed.
void fillClosedStandardStreams();

/// Properties of standard output, for programs that lay out text for people.
struct OutputTerminal {
  bool is_terminal = false;
  bool color = false;       ///< a terminal, NO_COLOR is unset and TERM is not "dumb"
  bool unicode = false;     ///< a terminal, and the locale says UTF-8
  std::size_t columns = 0;  ///< of the terminal; 0: none, or not known
};
OutputTerminal outputTerminal();

}  // namespace rocinante::cli
