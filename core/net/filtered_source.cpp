#include "core/net/filtered_source.h"

#include <algorithm>

namespace rocinante {
namespace {

// Unwanted batches per call: a flood of them must not look like silence, nor keep the caller from
// its other sources.
constexpr int kBatches = 16;

}  // namespace

bool FilteredSource::takes(const ReceivedDatagram& datagram) {
  if (!own_.empty() && std::find(own_.begin(), own_.end(), datagram.sender) != own_.end()) {
    ++echoes_;
    return false;
  }
  if (allow_.allows(datagram.sender)) return true;
  ++refused_;
  return false;
}

Result<std::span<const ReceivedDatagram>> FilteredSource::receive() {
  for (int turn = 0; turn < kBatches; ++turn) {
    const auto batch = inner_->receive();
    if (!batch || batch->empty()) return batch;
    const auto refused = std::find_if(batch->begin(), batch->end(),
                                      [&](const ReceivedDatagram& each) { return !takes(each); });
    if (refused == batch->end()) return batch;
    taken_.assign(batch->begin(), refused);
    for (auto each = refused + 1; each != batch->end(); ++each) {
      if (takes(*each)) taken_.push_back(*each);
    }
    if (!taken_.empty()) return std::span<const ReceivedDatagram>(taken_);
  }
  return std::span<const ReceivedDatagram>();
}

InputCounts FilteredSource::counts() const {
  InputCounts counts = inner_->counts();
  counts.refused += refused_;
  counts.echoes += echoes_;
  return counts;
}

}  // namespace rocinante
