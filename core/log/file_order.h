#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/span_cache.h"

namespace rocinante {

/// The order of the messages in the file, which is that of writing. Returns all messages in it,
/// each once, also while the file grows. Not for sharing between threads.
class FileOrder {
 public:
  /// Begins before the first message. The cache is borrowed and must outlive this.
  explicit FileOrder(SpanCache& cache) : cache_(cache) {}

  /// The cache's spans from `first_changed` on are others, with more messages; one that was there
  /// may be left out now, and one that was left out be there.
  void fileGrew(std::size_t first_changed);

  /// Empty when there is no more yet. The payload stays valid until the next call.
  std::optional<LogMessage> next();
  /// Goes behind the last message that is there.
  void skipAll();

  /// As LogReader::inOrderAt().
  bool inOrderAt(LogPosition place);

 private:
  void read();
  void findEarliest();

  SpanCache& cache_;
  std::uint32_t span_ = 0;
  std::uint64_t span_begin_ = 0;                  ///< of that span in the file, once it was read
  std::uint64_t behind_ = 0;                      ///< the messages before this offset were given
  std::shared_ptr<const SpanMessages> messages_;  ///< of the span; null: not read yet
  std::vector<SpanMessages::Place> ahead_;        ///< those not given yet, the next one last
  std::vector<LogTime> earliest_from_;            ///< of all messages from a span on
  std::size_t earliest_known_ = 0;                ///< the spans that it was found for
};

}  // namespace rocinante
