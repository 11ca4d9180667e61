#include "core/net/chosen_source.h"

#include <algorithm>

#include "core/report/account.h"

namespace rocinante {
namespace {

// Unwanted batches per call: a flood of them must not look like silence, nor keep the caller from
// its other sources.
constexpr int kBatches = 16;

}  // namespace

Account ChosenSource::leftOut() const { return inner_->leftOut(); }

bool ChosenSource::takes(const ReceivedDatagram& datagram) {
  const bool wanted = accepts(datagram);
  count_.note(wanted);
  return wanted;
}

Result<std::span<const ReceivedDatagram>> ChosenSource::receive() {
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

}  // namespace rocinante
