#pragma once

#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// Which distance is wanted: of a device or one of its links from another one, from a link of its
/// own, or from the nearest other device.
struct NearestQuery {
  std::string device;
  std::string link;        ///< empty: all of them
  std::string other;       ///< empty: the nearest device
  std::string other_link;  ///< empty: all of them
  bool operator==(const NearestQuery&) const = default;
};

/// The least distance of what was asked for at a moment.
struct NearestFound {
  NearestQuery wish;
  LogTime moment{};
  std::string other;  ///< the device; empty: there is nothing with geometry to measure
  double distance_m = 0;
  /// The nearest points, in the world; of two links of one device either way round.
  Vec3 on_device{}, on_other{};
};

/// The distance for the user, with the names of the links that were measured. `other` is not empty.
/// Pure.
std::string nearestText(const NearestFound& found);

/// Measures least distances as the judge of clearances does (ClearanceGauge), in a thread of its
/// own with a low priority: a large cell takes it longer than a frame. Of what is asked meanwhile
/// only the last counts. For one calling thread.
class NearestStudy {
 public:
  /// `cell` is borrowed, and read by the thread.
  explicit NearestStudy(const Cell& cell);

  /// Asks for the distance in a state, which is copied, unless the thread still works on another
  /// one: true when it was taken.
  bool ask(const NearestQuery& wish, const SessionState& state, LogTime moment);
  /// The last answer; empty before the first.
  std::optional<NearestFound> found() const;
  bool isBusy() const { return worker_.isBusy(); }
  /// True once after each answer.
  bool takeNews() { return worker_.takeNews(); }
  /// Until it is not busy.
  void wait() const { worker_.wait(); }

 private:
  struct Question {
    NearestQuery wish;
    SessionState state;
    LogTime moment;
  };
  class Gauge;
  Worker<Question, NearestFound> worker_;
};

}  // namespace rocinante
