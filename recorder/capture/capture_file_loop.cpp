#include "recorder/capture/capture_file_loop.h"

#include "core/transport/open_source.h"

namespace rocinante {

namespace {

/// While the queue is full, until the disk catches up.
constexpr Nanoseconds kFullPause = std::chrono::microseconds(500);

}  // namespace

Result<bool> CaptureFileLoop::pass() {
  if (left_.empty()) {
    const auto batch = source_.receive();
    if (!batch) return batch.error();
    left_ = *batch;
    if (left_.empty()) return passEmpty();
  }
  while (!left_.empty()) {
    if (!blocks_.keep(left_.front())) return false;
    left_ = left_.subspan(1);
  }
  return true;
}

Nanoseconds CaptureFileLoop::pauseAfter(bool moved) { return moved ? Nanoseconds(0) : kFullPause; }

Status CaptureFileLoop::finish() {
  blocks_.handOver();
  out_.finish();
  return {};
}

Result<std::optional<LogTime>> firstMoment(const Endpoint& file) {
  const auto source = openSource(file);
  if (!source) return source.error();
  while (!(*source)->ended()) {
    const auto batch = (*source)->receive();
    if (!batch) return batch.error();
    if (batch->empty()) continue;
    return std::optional(CaptureTime().at(batch->front().kernel_time));
  }
  return std::optional<LogTime>();
}

}  // namespace rocinante
