#pragma once

#include "core/base/time.h"
#include "viewer/ui/program/pointer_pace.h"
#include "viewer/ui/program/window_picture.h"

namespace rocinante {

/// Tells others, while the window publishes, where it looks from and where its mouse points. Main
/// thread; borrows both.
class ViewpointPublisher {
 public:
  ViewpointPublisher(ViewModel& model, WindowPicture& picture) : model_(model), picture_(picture) {}

  /// Sends what is due.
  Status tell(SteadyTime now);

 private:
  ViewModel& model_;
  WindowPicture& picture_;
  PointerPace pace_;
};

}  // namespace rocinante
