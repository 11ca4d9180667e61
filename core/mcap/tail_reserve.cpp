#include "core/mcap/tail_reserve.h"

#include <algorithm>

namespace rocinante {
namespace {

// An eighth of the file: few calls for a large one, little taken for a small one, which a recorder
// that is killed leaves allocated. Each call can wait for the file system's journal (62 ms were
// seen), while what is recorded waits in memory: the least keeps them rare in a new file.
constexpr std::uint64_t kLeastStep = 1U << 20U;
constexpr std::uint64_t kMaxStep = 16U << 20U;

}  // namespace

Status TailReserve::cover(ByteSink& sink, std::uint64_t end_bytes) {
  if (end_bytes <= ready_until_) return {};
  const std::uint64_t ahead = end_bytes + std::clamp(end_bytes / 8, kLeastStep, kMaxStep);
  if (sink.reserve(ahead)) {
    ready_until_ = ahead;
    return {};
  }
  // Near the end of the disk the step does not fit, but what is needed may.
  Status exactly = sink.reserve(end_bytes);
  if (exactly) ready_until_ = end_bytes;
  return exactly;
}

}  // namespace rocinante
