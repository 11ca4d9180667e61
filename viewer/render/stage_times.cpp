#include "viewer/render/stage_times.h"

#include <time.h>

namespace rocinante {
namespace {

std::int64_t nanosecondsOf(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

StageTime StageClock::now() {
  return {nanosecondsOf(CLOCK_THREAD_CPUTIME_ID), nanosecondsOf(CLOCK_MONOTONIC)};
}

void StageClock::endStage(StageTime& stage) {
  const StageTime at = now();
  stage += {at.cpu_ns - last_.cpu_ns, at.wall_ns - last_.wall_ns};
  last_ = at;
}

}  // namespace rocinante
