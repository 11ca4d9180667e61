#pragma once

namespace rocinante::cli {

/// Fills what is closed of the first three descriptors, before anything is opened: else a log or a
/// socket would get the number of standard output, and what the program says would be written into
/// it. What is filled refuses to be read or written, so that a lost report is still noticed.
void fillClosedStandardStreams();

}  // namespace rocinante::cli
