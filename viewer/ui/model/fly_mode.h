#pragma once

#include <optional>

#include "core/base/time.h"
#include "core/math/vector.h"

namespace rocinante {

/// The keys of flying that are down in a frame.
struct FlyKeys {
  bool forward = false, back = false, left = false, right = false, up = false, down = false;
  bool faster = false;  ///< changes the others; moves nothing alone

  bool any() const { return forward || back || left || right || up || down; }
};

/// Flying through the scene: from the first of its keys while the right mouse button is held until
/// the button goes up. How far depends on the frames' times alone, so that a recorded input flies
/// the same way again. Plain values; reads no clock.
class FlyMode {
 public:
  /// A person gets through the scene in about this time.
  static constexpr double kSecondsAcross = 6;
  static constexpr double kFaster = 4;  ///< with the key that makes it so
  /// A frame that took longer moves no farther: nobody saw where it went.
  static constexpr Nanoseconds kLongestStep{100'000'000};
  static constexpr Nanoseconds kFirstStep{1'000'000'000 / 60};

  bool active() const { return active_; }
  /// A key moves the view: frames are to follow each other.
  bool moving() const { return last_.has_value(); }
  /// Metres a second, without the key that makes it faster.
  double speed() const { return scene_m_ / kSecondsAcross * factor_; }
  /// The largest extent of what is shown, in metres; what is not a size is a metre.
  void setSceneSize(double metres);
  /// A step of the wheel is a quarter more, or as much less.
  void changeSpeed(double steps);

  /// One frame with the button held. How far the view moves in it, in metres: to the right,
  /// forward, and up.
  Vec3 step(const FlyKeys& keys, SteadyTime now);
  /// The button is up, or the keyboard is somebody else's.
  void end();

 private:
  bool active_ = false;
  std::optional<SteadyTime> last_;  ///< the last frame of this movement
  double scene_m_ = 1;
  double factor_ = 1;
};

}  // namespace rocinante
