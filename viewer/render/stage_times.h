#pragma once

#include <cstdint>

namespace rocinante {

/// CPU time of the calling thread, and wall time.
struct StageTime {
  std::int64_t cpu_ns = 0, wall_ns = 0;

  StageTime& operator+=(const StageTime& other) {
    cpu_ns += other.cpu_ns;
    wall_ns += other.wall_ns;
    return *this;
  }
};

/// Times of a frame by stage. Pictures do not depend on them.
struct StageTimes {
  StageTime app;   ///< poses and camera; the caller adds posing
  StageTime cull;  ///< visible items in drawing order
  StageTime draw;  ///< GL calls; GL's threads may still be working after them

  StageTimes& operator+=(const StageTimes& other) {
    app += other.app;
    cull += other.cull;
    draw += other.draw;
    return *this;
  }
};

/// Measures from construction and from each endStage().
class StageClock {
 public:
  StageClock() : last_(now()) {}
  /// Adds the time since then to `stage`.
  void endStage(StageTime& stage);

 private:
  static StageTime now();
  StageTime last_;
};

}  // namespace rocinante
