#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/span_cache.h"

namespace rocinante {

/// Finds the last message of a channel before a moment through the message indexes, and expands
/// only the span that holds it. An index that disagrees with its span is damage; then the span
/// itself is searched.
class LastMessage {
 public:
  /// The cache is borrowed and must outlive this.
  explicit LastMessage(SpanCache& cache);

  /// The last message of the channel at or before `moment`; its payload is borrowed until the next
  /// call.
  std::optional<LogMessage> find(ChannelId channel, LogTime moment);

 private:
  struct Found {
    std::uint32_t span = 0;
    SpanMessages::Place place{};
    bool by_index = false;

    bool operator<(const Found& other) const;
  };

  std::optional<Found> latest(ChannelId channel, LogTime moment);
  std::optional<Found> latestIn(std::uint32_t span, ChannelId channel, LogTime moment);
  std::optional<Found> readIn(std::uint32_t span, ChannelId channel, LogTime moment);

  SpanCache& cache_;
  std::vector<std::uint32_t> by_end_;         ///< spans, in order of their end time
  std::vector<LogTime> earliest_start_;       ///< of by_end_[i..]
  std::set<std::uint32_t> misindexed_;        ///< spans whose message indexes are wrong
  std::shared_ptr<const SpanMessages> held_;  ///< owns the payload of the last answer
};

}  // namespace rocinante
