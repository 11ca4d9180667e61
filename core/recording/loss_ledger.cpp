#include "core/recording/loss_ledger.h"

#include <algorithm>
#include <utility>

namespace rocinante {

void LossLedger::add(const EndpointLoss& loss) {
  if (gathering_.empty()) gathered_since_ = loss.until;
  addLoss(gathering_, loss);
  totals_[loss.endpoint] += loss.counts;
}

namespace {

/// Removes the entries of `losses` that ended by `time`, and returns them.
void moveUpTo(LogTime time, std::vector<EndpointLoss>& losses, std::vector<EndpointLoss>& out) {
  const auto not_yet = std::stable_partition(
      losses.begin(), losses.end(), [&](const EndpointLoss& each) { return each.until <= time; });
  out.insert(out.end(), losses.begin(), not_yet);
  losses.erase(losses.begin(), not_yet);
}

}  // namespace

std::vector<EndpointLoss> LossLedger::due(LogTime time) {
  if (time - gathered_since_ >= kSpan) {
    ripe_.insert(ripe_.end(), gathering_.begin(), gathering_.end());
    gathering_.clear();
  }
  std::vector<EndpointLoss> given;
  moveUpTo(time, ripe_, given);
  return given;
}

std::vector<EndpointLoss> LossLedger::upTo(LogTime time) {
  std::vector<EndpointLoss> given;
  moveUpTo(time, ripe_, given);
  moveUpTo(time, gathering_, given);
  return given;
}

std::vector<EndpointLoss> LossLedger::rest() {
  std::vector<EndpointLoss> given = std::exchange(ripe_, {});
  given.insert(given.end(), gathering_.begin(), gathering_.end());
  gathering_.clear();
  return given;
}

}  // namespace rocinante
