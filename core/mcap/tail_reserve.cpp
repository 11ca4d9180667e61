#include "core/mcap/tail_reserve.h"

#include <algorithm>

namespace rocinante {
namespace {

// An eighth of the file: few calls for a large file, little space for a small one, which stays
// allocated when a recorder is killed. Each call can wait for the file system's journal (62 ms were
// measured) while recorded data waits in memory: the minimum keeps calls rare in a new file.
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
  // Near the end of the disk the step does not fit, but the room needed now may.
  Status exactly = sink.reserve(end_bytes);
  if (exactly) ready_until_ = end_bytes;
  return exactly;
}

}  // namespace rocinante
