#pragma once

#include <cstdint>

namespace rocinante {

/// Counts how often this process continued after a stop (Ctrl-Z and fg, SIGSTOP and SIGCONT), from
/// watchResumes() on, which handles SIGCONT. Another handler of SIGCONT must call noteResume(),
/// which is safe in signal handlers.
void watchResumes();
void noteResume();
std::uint32_t resumeCount();

}  // namespace rocinante
