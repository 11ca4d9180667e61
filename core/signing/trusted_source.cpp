#include "core/signing/trusted_source.h"

namespace rocinante {

bool TrustedSource::wants(const ReceivedDatagram& datagram) {
  const auto reason = judge_->judge(datagram.payload, datagram.kernel_time);
  if (reason) untrusted_.add(*reason);
  return !reason;
}

InputCounts TrustedSource::counts() const {
  InputCounts counts = ChosenSource::counts();
  if (!counts.untrusted) counts.untrusted.emplace();
  *counts.untrusted += untrusted_;
  return counts;
}

}  // namespace rocinante
