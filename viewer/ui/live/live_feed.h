#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/datagram_source.h"
#include "core/net/endpoint.h"
#include "core/packet/session_state.h"
#include "viewer/ui/live/keep_limits.h"
#include "viewer/ui/live/live_keeper.h"
#include "viewer/ui/live/source_watch.h"

namespace rocinante {

class TrustJudge;

/// Figures of a live session, as of the last hand-over.
struct LiveFigures {
  LogTime time{};                ///< of the newest datagram
  std::uint64_t datagrams = 0;   ///< since the start
  std::uint64_t undecoded = 0;   ///< datagrams that are no packets, nor were decoded
  std::string undecoded_sample;  ///< the beginning of the first of them, printable
  std::uint64_t dropped = 0;     ///< by the kernel: its buffer was full
  UntrustedCounts untrusted;     ///< refused by --trust; not among `datagrams`
  std::uint64_t gaps = 0;        ///< sequence numbers never seen, all sources
  double rate_hz = 0;            ///< datagrams in the last second
  std::string news;    ///< what a source said last about receiving (DatagramSource::maintain)
  SteadyTime taken{};  ///< when it was handed over
};

/// A live session as the window knows it: brought up to date by LiveFeed::update().
struct LiveSnapshot : LiveFigures {
  SessionState state;
  std::vector<LiveSource> sources;
};

/// Listens in its own thread, so that packets do not delay frames and slow frames do not lose
/// packets: the thread folds everything received and hands over what changed whenever the window
/// has taken the last changes (one atomic exchange; neither waits for the other). The cost is that
/// of the packets, not of the session's size; only a window that was away for long gets a whole
/// copy. With a keeper, every datagram also goes to the kept log, at the same log time.
class LiveFeed {
 public:
  /// refused, as in openSource(), when it cannot listen on or watch an endpoint.
  /// `trust`, if set, judges every datagram; the feed's thread then owns it. With `keep`, what is
  /// heard is kept in a log; when that is impossible, keepingFault() tells why. With `decoders`,
  /// what is not packet text is decoded, here and in that log.
  static Result<LiveFeed> start(const std::vector<Endpoint>& endpoints,
                                std::shared_ptr<TrustJudge> trust = nullptr,
                                const std::optional<KeepLimits>& keep = std::nullopt,
                                LiveKeeper::Decoders decoders = nullptr);

  ~LiveFeed();
  LiveFeed(LiveFeed&&) noexcept;
  LiveFeed& operator=(LiveFeed&&) noexcept;

  /// Brings `live` up to date: false when there is nothing since the last call. It must be the one
  /// of all earlier calls. For one calling thread.
  bool update(LiveSnapshot& live);

  /// `wake` is called by the feed's thread whenever it has handed something over, so that nobody
  /// has to look for it all the time; empty: nobody is. Once this returns, no earlier one runs.
  void onNews(std::function<void()> wake);

  /// The kept log; null when nothing is kept.
  LiveKeeper* keeper() const;
  /// Why nothing is kept although it was asked for; empty otherwise.
  const std::string& keepingFault() const;

  const std::vector<Endpoint>& endpoints() const;

 private:
  struct Impl;
  explicit LiveFeed(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
