#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"
#include "tests/core/log/log_support.h"
#include "tests/core/packet/random_session.h"

namespace rocinante::test {

/// A datagram of a session with its log time.
struct TimedDatagram {
  LogTime time;
  std::string text;
};

/// The packets of RandomSession, from one second on.
inline std::vector<TimedDatagram> randomDatagrams(std::uint64_t seed, std::size_t count) {
  RandomSession session(seed);
  std::vector<TimedDatagram> datagrams;
  for (std::size_t i = 0; i < count; ++i) {
    const RandomSession::Datagram said = session.next();
    datagrams.push_back({at(std::llround(said.seconds * 1e9)), said.text});
  }
  return datagrams;
}

/// The fold of packets, by hand.
struct HandFold {
  SessionState state;
  std::unique_ptr<Decoder> decoder = makeDecoder("rk1");

  void fold(LogTime time, ByteView payload) {
    if (const Packet* packet = decoder->decode(payload)) state.apply(time, *packet);
    (void)state.takeEvents();
  }
};

inline SessionWriter makeSession(Bytes& out, const KeyframeOptions& keyframes,
                                 const LogWriterOptions& options = {}) {
  return SessionWriter(makeWriter(out, options), keyframes);
}

}  // namespace rocinante::test
