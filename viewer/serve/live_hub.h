#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/relay/relay.h"
#include "viewer/serve/client_queue.h"

namespace rocinante {

/// A live session for pages: folds what arrives, and writes one conflated stream that all clients
/// share, as a relay does for a listener with a rate (docs/decisions/026). One thread; reads no
/// clock.
class LiveHub {
 public:
  struct Options {
    std::string name;     ///< of the relay that it is for its clients
    std::string run;      ///< chosen anew at each start
    double rate_hz = 60;  ///< values of a device a second, at most
    /// Sees each packet that the fold applied, with its new events.
    std::function<void(const Packet&, const std::vector<Event>&)> applied{};
  };

  explicit LiveHub(Options options, LogTime now);

  /// `now` must not go back.
  void receive(ByteView datagram, LogTime now) { relay_.receive(datagram, now); }
  void advance(LogTime now) { relay_.advance(now); }
  /// When advance() has something to do.
  LogTime due() const { return relay_.due(); }

  /// What changed since the last call; empty when nothing did. To be called before
  /// what was received goes away.
  SharedMessage takeMessage(LogTime now);
  /// Everything, for a client that knows nothing: takeMessage() comes first, for the others.
  std::vector<SharedMessage> greeting(LogTime now) const;

  const SessionState& state() const { return relay_.state(); }
  const RelayInputCounts& counts() const { return relay_.counts(); }

 private:
  std::string name_;
  Relay relay_;
};

}  // namespace rocinante
