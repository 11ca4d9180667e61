#include "core/net/filtered_source.h"

#include <algorithm>

namespace rocinante {

bool FilteredSource::accepts(const ReceivedDatagram& datagram) {
  if (!own_.empty() && std::find(own_.begin(), own_.end(), datagram.sender) != own_.end()) {
    ++echoes_;
    return false;
  }
  if (!allow_.allows(datagram.sender)) {
    ++refused_;
    return false;
  }
  if (is_request_ != nullptr && is_request_(datagram.payload)) {
    ++requests_;
    return false;
  }
  return true;
}

InputCounts FilteredSource::counts() const {
  InputCounts counts = ChosenSource::counts();
  counts.refused += refused_;
  counts.requests += requests_;
  counts.echoes += echoes_;
  return counts;
}

}  // namespace rocinante
