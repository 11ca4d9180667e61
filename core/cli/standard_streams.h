#pragma once

namespace rocinante::cli {

/// Opens whatever is closed of the first three descriptors, before anything else is opened:
/// otherwise a log or a socket would get the number of standard output, and the program's output
/// would go into it. Descriptors opened here refuse reads and writes, so that a lost report is
/// still noticed.
void fillClosedStandardStreams();

}  // namespace rocinante::cli
