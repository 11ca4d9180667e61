#include "recorder/capture/capture_file_loop.h"

#include <algorithm>

#include "core/pcap/open_source.h"
#include "core/recording/reorder_window.h"

namespace rocinante {

namespace {

/// Well below the limit of 64-bit nanoseconds, so that adding a little cannot overflow.
constexpr Nanoseconds kLatest = std::chrono::seconds(9'200'000'000);

}  // namespace

LogTime CaptureTime::at(WallTime stamp) {
  // Log times lie between 1970 and kLatest. A clock that is set back again and again would exceed
  // it.
  const Nanoseconds since = std::clamp(stamp.time_since_epoch(), Nanoseconds(0), kLatest);
  const LogTime seen(std::min(since, kLatest - shift_) + shift_);
  if (!reached_) reached_ = seen;
  if (seen + kDisorder < *reached_) {
    step_ = ClockStep{*reached_, seen - *reached_};
    shift_ += *reached_ - seen;
    return *reached_;
  }
  reached_ = std::max(*reached_, seen);
  return *reached_;
}

Result<bool> CaptureFileLoop::pass() {
  if (left_.empty()) {
    const auto batch = source_.receive();
    if (!batch) return batch.error();
    left_ = *batch;
  }
  while (!left_.empty()) {
    if (!keep(left_.front())) return false;
    left_ = left_.subspan(1);
  }
  return true;
}

bool CaptureFileLoop::keep(const ReceivedDatagram& datagram) {
  // Make room first: time_.at() may be called only once per datagram.
  const std::size_t most = datagram.payload.size() + sizeof(SocketAddress);
  if (block_ && !block_->hasRoom(most)) handOverBlock();
  if (!block_) block_ = out_.freeBlock();
  if (!block_) return false;
  reached_ = time_.at(datagram.kernel_time);
  if (const auto step = time_.takeStep()) steps_.push_back(*step);
  block_->add(0, reached_, datagram.sender, datagram.payload, datagram.destination);
  if (datagram.truncated) {
    EndpointLoss loss{0, reached_, reached_, {}};
    loss.counts.truncated = 1;
    addLoss(losses_, loss);
  }
  return true;
}

void CaptureFileLoop::handOverBlock() {
  // Nothing earlier follows, so the writer need not hold these datagrams back.
  out_.give(std::move(block_), losses_, steps_, reached_ + ReorderWindow::kWidth);
}

void CaptureFileLoop::finish() {
  handOverBlock();
  out_.finish();
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
