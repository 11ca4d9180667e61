#pragma once

#include <chrono>

#include "viewer/ui/program/detail_choice.h"
#include "viewer/ui/program/warm_up.h"
#include "viewer/ui/program/window_picture.h"

namespace rocinante {

/// What a window makes of its picture while nothing is asked of it: first it gets ready for input
/// (WarmUp), then it draws the picture once more with everything, in slices. Main thread; borrows
/// both.
class PictureRest {
 public:
  PictureRest(WindowPicture& picture, DetailChoice& detail) : picture_(picture), detail_(detail) {}

  enum class News {
    none,
    begins,  ///< the first slice is due: to be said before it takes time
    whole,   ///< the picture has everything now
    ends,    ///< it is given up
  };
  /// Does one step, if there is one. `is_announced`: that it begins.
  Result<News> step(SteadyTime now, bool is_empty, bool is_announced);
  /// A step must not wait for a moment without a frame, since frame may follow frame, as of a live
  /// stream or a log that plays: what is shown would stay plain, and what stands still coarse.
  bool isOverdue(SteadyTime now, bool is_empty) const {
    return isDue(now, is_empty) && (!warmsUp(is_empty) || now - stepped_ >= kLongestWait);
  }
  /// A step is due. A rung that the user chose stays as it is.
  bool isDue(SteadyTime now, bool is_empty) const {
    return warmsUp(is_empty) || (!detail_.fixed() && picture_.refinesAt(now));
  }

 private:
  static constexpr Nanoseconds kLongestWait = std::chrono::milliseconds(200);

  bool warmsUp(bool is_empty) const {
    return !detail_.fixed() && picture_.isPlain() && !is_empty && !warm_up_.done();
  }

  WindowPicture& picture_;
  DetailChoice& detail_;
  WarmUp warm_up_;
  SteadyTime stepped_{};
};

}  // namespace rocinante
