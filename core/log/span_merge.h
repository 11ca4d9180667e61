#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/span_cache.h"

namespace rocinante {

/// Gives the messages of all spans in the order of (log_time, place in the file), forwards and
/// backwards, whatever order the spans are in and however they overlap. A span is expanded when its
/// time has come and let go when it is done; where very many overlap, those not just being read are
/// expanded again later, so that memory stays bounded.
class SpanMerge {
 public:
  /// Stands before the first message. The cache is borrowed and must outlive the merge.
  explicit SpanMerge(SpanCache& cache);

  /// Goes between two messages: those at or behind `place` are before us, those earlier behind us.
  void seek(LogPosition place);
  /// Behind the message at `place` and before any other.
  static LogPosition behind(LogPosition place);

  /// The first message before us, and goes behind it. The payload stays valid until the next call.
  std::optional<LogMessage> next() { return step(kForwards); }
  /// The last message behind us, and goes before it.
  std::optional<LogMessage> previous() { return step(kBackwards); }

 private:
  // Backwards is forwards with every time and place mirrored: ~x turns their order round.
  using Way = std::size_t;
  static constexpr Way kForwards = 0;
  static constexpr Way kBackwards = 1;
  std::int64_t mirrored(std::int64_t time_ns) const {
    return way_ == kForwards ? time_ns : ~time_ns;
  }
  std::uint64_t mirrored(std::uint64_t place) const { return way_ == kForwards ? place : ~place; }

  /// A span that is being read, by its next message.
  struct Open {
    std::int64_t time_ns = 0;  ///< of the next, mirrored
    std::uint64_t order = 0;   ///< its LogMessage::file_offset, mirrored
    std::uint32_t span = 0;
    std::size_t at = 0;                            ///< of the next in `messages->places`
    std::shared_ptr<const SpanMessages> messages;  ///< null when let go for want of room
  };
  struct Later {
    bool operator()(const Open& a, const Open& b) const {
      return a.time_ns != b.time_ns ? a.time_ns > b.time_ns : a.order > b.order;
    }
  };
  /// The spans as they begin, going one way.
  struct Order {
    std::vector<std::uint32_t> spans;      ///< by (mirrored start, place in the file)
    std::vector<std::int64_t> latest_end;  ///< of spans[0..i], mirrored: where a seek can begin
  };

  std::int64_t startOf(std::uint32_t span) const;
  std::int64_t endOf(std::uint32_t span) const;
  void sortSpans();
  void begin(Way way);
  std::optional<LogMessage> step(Way way);
  void openNextSpan();
  void advance();
  bool reload(Open& open);
  void dropFirst();
  void letOthersGo();
  void take(Open& open);

  SpanCache& cache_;
  std::array<Order, 2> orders_;
  Way way_ = kForwards;
  bool begun_ = false;  ///< open_ is what lies ahead, going that way from `place_`
  /// Where we stand: messages before it are behind us.
  LogPosition place_;
  LogPosition from_;                ///< where open_ was begun
  std::size_t next_span_ = 0;       ///< in the order of the way
  std::vector<Open> open_;          ///< a heap: the first to come first
  bool given_ = false;              ///< the first of open_ was given out
  std::size_t held_limit_ = 0;      ///< of expanded spans together; grows where they alternate
  std::size_t expanded_again_ = 0;  ///< bytes since it last grew
};

}  // namespace rocinante
