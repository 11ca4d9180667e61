#pragma once

namespace rocinante {

/// Asks the system to run the calling thread soon after it wakes, even beside busy programs: more
/// weight (nice -10) if this process may have it, and in any case the shortest time slice, which
/// means the earliest deadline since Linux 6.12. Refused requests change nothing.
/// docs/decisions/005.
void askToRunPromptly();

}  // namespace rocinante
