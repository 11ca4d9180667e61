#pragma once

#include <deque>
#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// The status line of a recording: time, rate, packets, losses, size, queue, and how long the disk
/// lasts. The packet rate covers the last second, the disk rate the last ten.
class RecordStatus {
 public:
  /// The time of `now` must not go back.
  std::string text(const RecordProgress& now);

 private:
  const RecordProgress& before(Nanoseconds elapsed) const;

  std::deque<RecordProgress> reported_;  ///< over the last ten seconds
};

/// The summary of a recording. Texts end without a newline.

/// A few lines for the user.
std::string summaryText(const RecordSummary& summary);

/// docs/programs/record.md, "JSON".
std::string summaryJson(const RecordSummary& summary);

}  // namespace rocinante
