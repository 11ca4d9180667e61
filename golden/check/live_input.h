#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/live/received_decoder.h"
#include "core/log/log_types.h"
#include "core/recording/session_clock.h"
#include "core/transport/open_source.h"

namespace rocinante {

/// Which time line the datagrams of a LiveInput are put on.
enum class LiveTime : std::uint8_t {
  arrival,  ///< the kernel's times, never decreasing
  steady,   ///< the session's own, which a clock that is set does not move
};

/// A datagram as a judge takes it; borrowed for the call.
struct LiveDatagram {
  std::string_view encoding;
  ByteView payload;
  std::string_view sender;                  ///< its address and port; empty: not known
  std::optional<std::string_view> decoded;  ///< the packet text that a decoder made of it
  std::span<const NotFiniteField> not_finite;
};

/// Gives it to a SessionCheck or a FindingWatch.
template <class Judge>
void judge(Judge& judge, LogTime time, const LiveDatagram& datagram) {
  for (const NotFiniteField& each : datagram.not_finite) judge.addNotFinite(time, each);
  if (!datagram.decoded) {
    return judge.add(time, datagram.encoding, true, datagram.payload, datagram.sender);
  }
  judge.addOctets(time, datagram.encoding, true);
  judge.add(time, "rk1", false, bytesOf(*datagram.decoded), datagram.sender);
}

/// The datagrams that several endpoints receive, in the order of one time line that never
/// decreases. One thread.
class LiveInput {
 public:
  using Take = std::function<void(LogTime, const LiveDatagram&)>;

  /// Opens all endpoints; fails as openSources() does. With a trust file, only what it trusts is
  /// received. `decoders` make packets of what is not packet text; null for none.
  static Result<LiveInput> open(const std::vector<std::string>& endpoints,
                                const std::string& trust_file,
                                std::shared_ptr<const decode::DecoderSet> decoders, LiveTime time,
                                Take take);

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
  /// Warns of subscriptions that were never accepted, and of endpoints at which nothing arrived,
  /// when something did at another.
  void warnOfSilence() const;
  /// What the trust file refused, by reason; empty without one.
  std::optional<UntrustedCounts> untrusted() const;
  /// What the decoders made; empty without any.
  std::optional<decode::DecodeAccount> decoded() const;

  std::optional<LogTime> first() const { return first_; }
  std::optional<LogTime> last() const { return last_; }

 private:
  LiveInput(Sources sources, std::shared_ptr<const decode::DecoderSet> decoders, LiveTime time,
            Take take);
  void take(std::size_t index, const ReceivedDatagram& datagram);
  Status drain(std::size_t index);

  Sources sources_;
  Take take_;
  std::unique_ptr<ReceivedDecoder> decoder_;  ///< null without decoders
  std::optional<SessionClock> clock_;         ///< of LiveTime::steady
  SocketAddress sender_;                      ///< of the last datagram
  std::string sender_text_;                   ///< empty before the first
  std::vector<std::uint64_t> received_, dropped_;
  std::vector<std::string> names_;
  std::optional<LogTime> first_, last_, losses_until_;
};

}  // namespace rocinante
