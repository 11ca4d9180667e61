#pragma once

#include <deque>
#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// One line on how a recording stands: time, rate, packets, losses, size, queue, and how long the
/// disk lasts. The rate of packets is that of the last second, that of the disk of the last ten.
class RecordStatus {
 public:
  /// The times of `now` do not go back.
  std::string text(const RecordProgress& now);

 private:
  const RecordProgress& before(Nanoseconds elapsed) const;

  std::deque<RecordProgress> told_;  ///< of the last ten seconds
};

}  // namespace rocinante
