#pragma once

#include <chrono>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// What the program does beside the model, as far as panels tell of it.
struct ProgramBusy {
  bool loading = false;
  bool notice = false;  ///< one is shown, or work is going on that will end with one
  bool typing = false;  ///< a caret blinks
};

/// How often panels change by themselves: a notice goes, a caret blinks, and live figures tell how
/// long ago something came; zero: the view flies. Nanoseconds::max(): never.
Nanoseconds panelsChangeEvery(const ViewModel& model, const ProgramBusy& busy, SteadyTime now);

/// How often the figures of a session change that has been silent so long: a whole picture of the
/// window each time, which software GL draws in 30 ms.
constexpr Nanoseconds agesChangeEvery(Nanoseconds silent) {
  return std::chrono::seconds(silent < std::chrono::seconds(5) ? 1 : 5);
}

/// Nothing moves: when to look at mouse, network and background again, in seconds.
double newsWait(const ViewModel& model);

}  // namespace rocinante
