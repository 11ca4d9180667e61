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
  /// What is tried: each is drawn once to compile, and again to be measured.
  struct Trial {
    int rung = 0;
    bool drops_looks = true;
  };
  void measured(double cost_ms, DetailChoice& detail);

  std::optional<Trial> trial_;  ///< empty: not begun
  bool is_compiled_ = false;
  bool is_estimate_ = true;  ///< the trial is not yet that of a choice
  enum class Step { frames, click, done };
  Step step_ = Step::frames;
};

}  // namespace rocinante
