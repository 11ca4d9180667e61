#include "recorder/capture/stream_loop.h"

#include <utility>

namespace rocinante {

Result<bool> StreamLoop::pass() {
  source_.confirm(saved_.load());
  if (const auto news = source_.maintain()) notes_.say(*news);
  const Result<bool> moved = CaptureFileLoop::pass();
  if (moved && *moved) noteGone();
  return moved;
}

bool StreamLoop::passEmpty() {
  // The writer gets what has come: a stream may stay quiet for hours.
  blocks_.handOver();
  return false;
}

Status StreamLoop::finish() {
  noteGone();
  return CaptureFileLoop::finish();
}

void StreamLoop::noteGone() {
  const std::uint64_t dropped = source_.dropped();
  if (dropped == gone_) return;
  LossCounts counts;
  counts.kernel = dropped - std::exchange(gone_, dropped);
  noteLoss(counts);
}

}  // namespace rocinante
