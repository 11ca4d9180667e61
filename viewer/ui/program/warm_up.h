#pragma once

#include <optional>

#include "viewer/ui/program/detail_choice.h"
#include "viewer/ui/program/window_picture.h"

namespace rocinante {

/// Gets a window ready for its first input, after its first picture is there: has the driver
/// compile what a drag and a click need, and measures what a frame costs, so that the first drag
/// begins on a rung of detail that this machine draws in time. Nothing of it is seen. Main thread.
class WarmUp {
 public:
  /// Does one step, which takes about a frame; false: there is nothing left to do. A fault of the
  /// driver is that of the next frame, and ends it.
  bool advance(WindowPicture& picture, DetailChoice& detail);
  bool done() const { return step_ == Step::done; }

 private:
  enum class Step { compile, measure, chosen, click, done };
  Step step_ = Step::compile;
};

}  // namespace rocinante
