#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "core/packet/session_state.h"
#include "viewer/ui/live/source_watch.h"

namespace rocinante {

/// Data passed from the network thread to the window: a complete state, and figures of the last
/// second.
struct LiveSnapshot {
  SessionState state;
  LogTime time{};                ///< of the newest datagram
  std::uint64_t datagrams = 0;   ///< since the start
  std::uint64_t undecoded = 0;   ///< datagrams that are not packets
  std::string undecoded_sample;  ///< the beginning of the first of them, printable
  std::uint64_t dropped = 0;     ///< by the kernel: its buffer was full
  std::uint64_t gaps = 0;        ///< sequence numbers never seen, all sources
  double rate_hz = 0;            ///< datagrams in the last second
  std::vector<LiveSource> sources;
  SteadyTime taken{};  ///< when it was handed over
};

/// Listens in its own thread, so that packets do not delay frames and slow frames do not lose
/// packets: the thread folds everything received and hands over a copy whenever the window has
/// taken the last one (one atomic exchange; neither waits for the other).
class LiveFeed {
 public:
  /// refused, as in openSource(), when it cannot listen on or watch an endpoint.
  static Result<LiveFeed> start(const std::vector<Endpoint>& endpoints);

  ~LiveFeed();
  LiveFeed(LiveFeed&&) noexcept;
  LiveFeed& operator=(LiveFeed&&) noexcept;

  /// The newest snapshot, or null when there is none since the last call. For one calling thread.
  std::unique_ptr<LiveSnapshot> take();

  const std::vector<Endpoint>& endpoints() const;

 private:
  struct Impl;
  explicit LiveFeed(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
