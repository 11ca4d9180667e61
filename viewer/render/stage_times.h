#pragma once

#include <cstdint>

namespace rocinante {

/// CPU of the calling thread, and time on the wall.
struct StageTime {
  std::int64_t cpu_ns = 0, wall_ns = 0;

  StageTime& operator+=(const StageTime& other) {
    cpu_ns += other.cpu_ns;
    wall_ns += other.wall_ns;
    return *this;
  }
};

/// What a frame took, stage by stage. A picture never depends on it.
struct StageTimes {
  StageTime app;   ///< where everything is, seen from where; posing adds the caller
  StageTime cull;  ///< what of it can be seen, in which order
  StageTime draw;  ///< telling GL, which may go on in threads of its own after that

  StageTimes& operator+=(const StageTimes& other) {
    app += other.app;
    cull += other.cull;
    draw += other.draw;
    return *this;
  }
};

/// Runs from when it was made, and from each endStage() on.
class StageClock {
 public:
  StageClock() : last_(now()) {}
  /// Adds what went by since to `stage`.
  void endStage(StageTime& stage);

 private:
  static StageTime now();
  StageTime last_;
};

}  // namespace rocinante
