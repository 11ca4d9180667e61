#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/time.h"
#include "core/packet/packet.h"
#include "core/relay/restating.h"

namespace rocinante {

/// Holds a link to a number of bytes a second. One datagram may be sent while there are tokens; it
/// may leave a debt, which is waited for. Reads no clock.
class TokenBucket {
 public:
  /// `burst_bytes`: what may be sent at once after silence.
  TokenBucket(double bytes_per_second, double burst_bytes, LogTime now)
      : rate_(bytes_per_second), burst_(burst_bytes), tokens_(burst_bytes), counted_(now) {}

  bool allows(LogTime now) {
    tokens_ = std::min(burst_, tokens_ + secondsOf(now - counted_) * rate_);
    counted_ = now;
    return tokens_ > 0;
  }
  void spend(std::size_t bytes) { tokens_ -= static_cast<double>(bytes); }
  /// When allows() will be true, as of the last call of it.
  LogTime allowsAt() const {
    if (tokens_ > 0) return counted_;
    return counted_ + Nanoseconds(static_cast<std::int64_t>(-tokens_ / rate_ * 1e9) + 1);
  }

 private:
  double rate_, burst_, tokens_;
  LogTime counted_;
};

/// Statements that wait for a slow link, and how many had no room to wait.
struct PacedCounts {
  std::uint64_t waiting = 0;  ///< now
  std::uint64_t most = 0;     ///< at any time
  /// Beyond PacedStatements::kMaxBytes or kMaxStates; the link never gets these.
  std::uint64_t dropped = 0;

  /// Of several outputs: `most` is then the sum of each one's.
  PacedCounts& operator+=(const PacedCounts& others);
};

/// What a slow output sends statement by statement instead of by item, in the order in which it
/// came: every event, each change that an item cannot hold (`remove`, `erase`, `order`), of which
/// only the newest about one thing waits, and each state of a signal. Memory is bounded. One
/// thread.
class PacedStatements {
 public:
  /// Of both together; 5 minutes of 28.8 kbit/s.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20U;
  /// Of one signal: the newest state then takes the place of the one before it.
  static constexpr std::size_t kMaxStates = 64;
  /// Bytes that a datagram has for statements of this SOURCE.
  using RoomFor = std::function<std::size_t(const std::string&)>;

  void add(std::string_view source, const Statement& statement);

  bool anyEvents() const { return !events_.empty(); }
  bool anyChanges() const { return !changes_.empty(); }
  /// The oldest that are of one SOURCE and fit into one datagram, at least one.
  RelayDraft takeEvents(const RoomFor& room);
  RelayDraft takeChanges(const RoomFor& room);

  PacedCounts counts() const;

 private:
  struct Waiting {
    std::string source;
    std::string text;  ///< with its LF
  };
  /// What a change is about: kind, SOURCE ("" for all), name.
  using Subject = std::tuple<StatementKind, std::string, std::string>;

  static Subject subjectOf(std::string_view source, const Statement& statement);
  void erase(std::uint64_t change);
  bool hasRoom(std::size_t bytes) const { return bytes_ + bytes <= kMaxBytes; }
  static std::size_t bytesOf(const Waiting& waiting);
  void noteMost();

  std::deque<Waiting> events_;
  std::map<std::uint64_t, std::pair<Waiting, Subject>> changes_;  ///< by when they came
  /// The changes about each that wait, oldest first: of anything but a signal one at most.
  std::map<Subject, std::vector<std::uint64_t>> about_;
  std::uint64_t came_ = 0;
  std::size_t bytes_ = 0;
  std::uint64_t most_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace rocinante
