#pragma once

namespace rocinante {

/// Asks the system to run the calling thread soon after it wakes, also beside programs that
/// compute all the time: more weight (nice -10) where this process may have it, and in any case the
/// shortest time slice, which since Linux 6.12 means the earliest deadline. What is refused stays
/// as it was. docs/decisions/005.
void askToRunPromptly();

}  // namespace rocinante
