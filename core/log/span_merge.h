#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/span_cache.h"

namespace rocinante {

/// Returns the messages of all spans in the order of (log_time, position in the file), forwards and
/// backwards, for any order and overlap of spans. A span is expanded when its time has come and
/// released when it is done; if very many overlap, those not being read are released and expanded
/// again later, so that memory stays bounded.
class SpanMerge {
 public:
  /// Begins before the first message. The cache is borrowed and must outlive the merge.
  explicit SpanMerge(SpanCache& cache) : cache_(cache) {}
  /// The cache's spans from `first_changed` on are others. Begins before the first message.
  void fileGrew(std::size_t first_changed);

  /// Moves between two messages: those at or behind `place` are ahead, earlier ones behind.
  void seek(LogPosition place);
  /// The position after the message at `place` and before any other.
  static LogPosition behind(LogPosition place);

  /// The next message ahead, and moves past it. The payload stays valid until the next call.
  std::optional<LogMessage> next() { return step(kForwards); }
  /// The last message behind, and moves before it.
  std::optional<LogMessage> previous() { return step(kBackwards); }

 private:
  static constexpr LogPosition kBeginning{LogTime::min(), 0};

  // Backwards is forwards with every time and position mirrored: ~x reverses their order.
  using Way = std::size_t;
  static constexpr Way kForwards = 0;
  static constexpr Way kBackwards = 1;
  std::int64_t mirrored(std::int64_t time_ns) const {
    return way_ == kForwards ? time_ns : ~time_ns;
  }
  std::uint64_t mirrored(std::uint64_t place) const { return way_ == kForwards ? place : ~place; }

  /// A span being read, positioned at its next message.
  struct Open {
    std::int64_t time_ns = 0;  ///< of the next, mirrored
    std::uint64_t order = 0;   ///< its LogMessage::file_offset, mirrored
    std::uint32_t span = 0;
    std::size_t at = 0;                            ///< of the next in `messages->places`
    std::shared_ptr<const SpanMessages> messages;  ///< null when released for lack of room
  };
  struct Later {
    bool operator()(const Open& a, const Open& b) const {
      return a.time_ns != b.time_ns ? a.time_ns > b.time_ns : a.order > b.order;
    }
  };
  /// The spans in the order of their beginnings, in one direction, as far as sorted.
  struct Order {
    std::vector<std::uint32_t> spans;      ///< by (mirrored start, place in the file)
    std::vector<std::int64_t> latest_end;  ///< of spans[0..i], mirrored: used by seek()
  };

  std::int64_t startOf(std::uint32_t span) const;
  std::int64_t endOf(std::uint32_t span) const;
  void sortNewSpans();
  void begin(Way way);
  std::optional<LogMessage> step(Way way);
  void openNextSpan();
  void advance();
  bool reload(Open& open);
  void dropFirst();
  void releaseOthers();
  void take(Open& open);

  SpanCache& cache_;
  std::array<Order, 2> orders_;
  Way way_ = kForwards;
  bool begun_ = false;  ///< open_ holds the spans ahead, in direction `way_` from `place_`
  /// The current position: messages before it are behind.
  LogPosition place_ = kBeginning;
  LogPosition from_;                ///< the position at which open_ was built
  std::size_t next_span_ = 0;       ///< in the order of the direction
  std::vector<Open> open_;          ///< a heap: the next message on top
  bool given_ = false;              ///< the top of open_ was returned
  std::size_t held_limit_ = 0;      ///< bytes of all expanded spans; grows where they alternate
  std::size_t expanded_again_ = 0;  ///< bytes since it last grew
};

}  // namespace rocinante
