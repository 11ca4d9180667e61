#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"

namespace rocinante {

/// Gives the messages of all spans in the order of (log_time, place in the file), whatever order
/// the spans are in and however they overlap. A span is expanded when its time has come and let go
/// when it is done; where very many overlap, those not just being read are expanded again later, so
/// that memory stays bounded.
class SpanMerge {
 public:
  /// All are borrowed and must outlive the merge; damage is appended to `damage`, once a span.
  /// `channels` is by id, null where there is none.
  SpanMerge(ByteView file, const std::vector<MessageSpan>& spans,
            const std::vector<const LogChannel*>& channels, std::vector<DamageSpan>& damage);

  /// The next message will be the first at or after `moment`.
  void seek(LogTime moment);

  /// The payload stays valid until the next call on this.
  std::optional<LogMessage> next();

 private:
  /// A span that is being read, by its next message.
  struct Open {
    std::int64_t time_ns = 0;
    std::uint64_t order = 0;  ///< LogMessage::file_offset
    std::uint32_t span = 0;
    std::size_t at = 0;                      ///< of the next in `messages->places`
    std::unique_ptr<SpanMessages> messages;  ///< null when let go for want of room
  };
  struct Later {
    bool operator()(const Open& a, const Open& b) const {
      return a.time_ns != b.time_ns ? a.time_ns > b.time_ns : a.order > b.order;
    }
  };

  void openNextSpan();
  std::unique_ptr<SpanMessages> load(std::uint32_t span);
  void report(std::uint32_t span, SpanMessages& messages);
  void advance();
  void letOthersGo();
  void recycle(std::unique_ptr<SpanMessages> messages);

  const std::vector<MessageSpan>& spans_;
  const std::vector<const LogChannel*>& channels_;
  std::vector<DamageSpan>& damage_;
  SpanDecoder decoder_;

  std::vector<std::uint32_t> by_start_;   ///< spans in order of (start, place in the file)
  std::vector<std::int64_t> latest_end_;  ///< of by_start_[0..i]: where a seek can begin
  std::vector<bool> reported_;            ///< by span: its damage is listed
  std::int64_t from_ns_;                  ///< of the last seek
  std::size_t next_span_ = 0;             ///< in by_start_
  std::vector<Open> open_;                ///< a heap: the earliest first
  bool given_ = false;                    ///< the first of open_ was given out by next()
  std::vector<std::unique_ptr<SpanMessages>> spare_;
};

}  // namespace rocinante
