#pragma once

#include <cstdint>

namespace rocinante {

/// How often this process went on after it was stopped (Ctrl-Z and fg, SIGSTOP and SIGCONT). Counts
/// from watchResumes() on, which handles SIGCONT; whoever handles it in its place calls
/// noteResume(), which may be called by a signal handler.
void watchResumes();
void noteResume();
std::uint32_t resumeCount();

}  // namespace rocinante
