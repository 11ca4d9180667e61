#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_types.h"
#include "core/recording/session_clock.h"
#include "core/transport/open_source.h"

namespace rocinante {

/// Which time line the datagrams of a LiveInput are put on.
enum class LiveTime : std::uint8_t {
  arrival,  ///< the kernel's times, never decreasing
  steady,   ///< the session's own, which a clock that is set does not move
};

/// The datagrams that several endpoints receive, in the order of one time line that never
/// decreases. One thread.
class LiveInput {
 public:
  /// A datagram as a judge takes it; borrowed for the call.
  using Take = std::function<void(LogTime, std::string_view encoding, ByteView payload)>;

  /// Opens all endpoints; fails as openSources() does. With a trust file, only what it trusts is
  /// received.
  static Result<LiveInput> open(const std::vector<std::string>& endpoints,
                                const std::string& trust_file, LiveTime time, Take take);

  /// A capture file, which has times of its own and ends.
  bool isFile() const { return !sources_[0]->endpoint().file.empty(); }
  bool ended() const { return sources_[0]->ended(); }
  /// The endpoints with their bound ports: ":0" takes a free one.
  std::string names() const;

  /// Waits for datagrams, at most this long, and hands over those that wait.
  Status pass(std::int64_t wait_ms);
  /// The time reached: now, or the latest datagram's of a file. Empty in a file before the first.
  std::optional<LogTime> now();

  /// What the kernel dropped since the last call, one span an endpoint.
  std::vector<LossSpan> takeLosses();
  /// Warns of endpoints at which nothing arrived, when something did at another.
  void warnOfSilence() const;
  /// What the trust file refused, by reason; empty without one.
  std::optional<UntrustedCounts> untrusted() const;

  std::optional<LogTime> first() const { return first_; }
  std::optional<LogTime> last() const { return last_; }

 private:
  LiveInput(Sources sources, LiveTime time, Take take);
  Status drain(std::size_t index);

  Sources sources_;
  Take take_;
  std::optional<SessionClock> clock_;  ///< of LiveTime::steady
  std::vector<std::uint64_t> received_, dropped_;
  std::vector<std::string> names_;
  std::optional<LogTime> first_, last_, losses_until_;
};

}  // namespace rocinante
