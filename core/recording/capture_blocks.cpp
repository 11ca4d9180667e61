#include "core/recording/capture_blocks.h"

#include <utility>

#include "core/recording/reorder_window.h"

namespace rocinante {

bool CaptureBlocks::keep(const ReceivedDatagram& datagram) {
  // Make room first: time_.at() may be called only once per datagram.
  const std::size_t most =
      datagram.payload.size() + datagram.subject.size() + sizeof(SocketAddress);
  if (block_ && !block_->hasRoom(most)) handOver();
  if (!block_) block_ = out_.freeBlock();
  if (!block_) return false;
  reached_ = time_.at(datagram.kernel_time);
  if (const auto step = time_.takeStep()) steps_.push_back(*step);
  block_->add(0, *reached_, datagram.sender, datagram.payload, datagram.destination,
              datagram.subject);
  if (datagram.truncated) {
    LossCounts counts;
    counts.truncated = 1;
    noteLoss(counts, *reached_);
  }
  return true;
}

void CaptureBlocks::noteLoss(const LossCounts& counts, LogTime otherwise) {
  const LogTime at = reached_.value_or(otherwise);
  addLoss(losses_, {0, at, at, counts});
}

void CaptureBlocks::handOver() {
  // Nothing earlier follows, so the writer need not hold these datagrams back.
  const auto drained = reached_ ? std::optional(*reached_ + ReorderWindow::kWidth) : std::nullopt;
  out_.give(std::move(block_), losses_, steps_, drained);
}

}  // namespace rocinante
