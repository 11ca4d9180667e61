#include "recorder/loss_ledger.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rocinante {

void LossLedger::add(const EndpointLoss& loss) {
  if (gathering_.empty()) gathered_since_ = loss.until;
  addLoss(gathering_, loss);
  totals_[loss.endpoint] += loss.counts;
}

std::vector<EndpointLoss> LossLedger::due(LogTime time) {
  if (time - gathered_since_ >= kSpan) {
    ripe_.insert(ripe_.end(), gathering_.begin(), gathering_.end());
    gathering_.clear();
  }
  const auto not_yet = std::stable_partition(
      ripe_.begin(), ripe_.end(), [&](const EndpointLoss& each) { return each.until <= time; });
  std::vector<EndpointLoss> given(std::make_move_iterator(ripe_.begin()),
                                  std::make_move_iterator(not_yet));
  ripe_.erase(ripe_.begin(), not_yet);
  return given;
}

std::vector<EndpointLoss> LossLedger::rest() {
  std::vector<EndpointLoss> given = std::exchange(ripe_, {});
  given.insert(given.end(), gathering_.begin(), gathering_.end());
  gathering_.clear();
  return given;
}

}  // namespace rocinante
