#pragma once

#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// Which distance is wanted: of a device from another one, or from the nearest other.
struct NearestQuery {
  std::string device;
  std::string other;  ///< empty: the nearest
  bool operator==(const NearestQuery&) const = default;
};

/// The least distance of two devices at a moment.
struct NearestFound {
  NearestQuery wish;
  LogTime moment{};
  std::string other;  ///< empty: there is no device with geometry to measure
  double distance_m = 0;
  Vec3 on_device{}, on_other{};  ///< the nearest points, in the world
};

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
