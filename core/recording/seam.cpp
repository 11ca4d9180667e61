#include "core/recording/seam.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kMaxWait = std::chrono::seconds(1);

}  // namespace

bool seamFits(const SessionState& state, LogTime time, LogTime since) {
  return !state.restatementOpen(time) || time - since >= kMaxWait;
}

LogTime intervalBegin(LogTime time, LogTime origin, Nanoseconds length) {
  const Nanoseconds passed = time - origin;
  const std::int64_t below = passed % length < Nanoseconds(0) ? 1 : 0;
  return origin + (passed / length - below) * length;
}

}  // namespace rocinante
