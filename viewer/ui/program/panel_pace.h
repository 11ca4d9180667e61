#pragma once

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
Nanoseconds panelsChangeEvery(const ViewModel& model, const ProgramBusy& busy);

/// Nothing moves: when to look at mouse, network and background again, in seconds.
double newsWait(const ViewModel& model);

}  // namespace rocinante
