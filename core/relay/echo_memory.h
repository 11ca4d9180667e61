#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// By which way a datagram reached a relay: one number for each endpoint and sender.
using ArrivalWay = std::uint64_t;
inline constexpr ArrivalWay kUnknownWay = 0;  ///< a server tells no sender

/// What a relay passed on lately, so that it knows its own datagrams when a loop brings them back
/// (docs/decisions/032). Memory is bounded. One thread; reads no clock.
class EchoMemory {
 public:
  /// Loops that take longer are not noticed.
  static constexpr Nanoseconds kSpan = std::chrono::seconds(2);
  static constexpr std::size_t kDatagrams = 65'536;

  /// A datagram, and what the fold will make of it.
  struct Arrival {
    ByteView datagram;
    const PacketHeader& header;
    std::string_view through;  ///< of `datagram`; not part of what is compared
    ArrivalWay way = kUnknownWay;
    LogTime now;
  };

  /// How long ago this relay passed on what has come back; empty when it is not an echo. `state` is
  /// the one before the datagram is applied.
  std::optional<Nanoseconds> echoAfter(const Arrival& arrival, const SessionState& state);
  /// The datagram of the last echoAfter() was applied, and goes on.
  void passed(const Arrival& arrival);

 private:
  struct Passed {
    LogTime time;
    ArrivalWay way = kUnknownWay;
  };
  struct Source {
    ArrivalWay way = kUnknownWay;  ///< of the newest
    LogTime time;                  ///< of the newest
    ArrivalWay reset = kUnknownWay;
  };
  struct Keys {
    std::uint64_t bytes = 0, header = 0;
  };

  void findKeys(const Arrival& arrival);
  void forget(LogTime now);
  void remember(std::uint64_t key, const Passed& passed);
  void noteEchoing(ArrivalWay way, LogTime now);
  bool isEchoing(ArrivalWay way, LogTime now) const;
  bool isOlder(const Arrival& arrival, const SessionState& state) const;

  std::unordered_map<std::uint64_t, Passed> passed_;
  std::deque<std::pair<LogTime, std::uint64_t>> order_;  ///< of passed_, oldest first
  std::unordered_map<ArrivalWay, LogTime> echoing_;      ///< ways that brought echoes: the last
  std::map<std::string, Source, std::less<>> sources_;
  Keys keys_;         ///< of the last arrival
  std::string text_;  ///< scratch
};

}  // namespace rocinante
