#include "recorder/capture/capture_file_loop.h"

#include "core/recording/reorder_window.h"
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
    if (!keep(left_.front())) return false;
    left_ = left_.subspan(1);
  }
  return true;
}

bool CaptureFileLoop::keep(const ReceivedDatagram& datagram) {
  // Make room first: time_.at() may be called only once per datagram.
  const std::size_t most =
      datagram.payload.size() + datagram.subject.size() + sizeof(SocketAddress);
  if (block_ && !block_->hasRoom(most)) handOverBlock();
  if (!block_) block_ = out_.freeBlock();
  if (!block_) return false;
  reached_ = time_.at(datagram.kernel_time);
  if (const auto step = time_.takeStep()) steps_.push_back(*step);
  block_->add(0, *reached_, datagram.sender, datagram.payload, datagram.destination,
              datagram.subject);
  if (datagram.truncated) {
    LossCounts counts;
    counts.truncated = 1;
    noteLoss(counts);
  }
  return true;
}

void CaptureFileLoop::noteLoss(const LossCounts& counts) {
  const LogTime at = reached_.value_or(begins_);
  addLoss(losses_, {0, at, at, counts});
}

void CaptureFileLoop::handOverBlock() {
  // Nothing earlier follows, so the writer need not hold these datagrams back.
  const auto drained = reached_ ? std::optional(*reached_ + ReorderWindow::kWidth) : std::nullopt;
  out_.give(std::move(block_), losses_, steps_, drained);
}

Nanoseconds CaptureFileLoop::pauseAfter(bool moved) { return moved ? Nanoseconds(0) : kFullPause; }

Status CaptureFileLoop::finish() {
  handOverBlock();
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
