#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/session/session_support.h"

namespace rocinante::test {

/// A session of random datagrams with keyframes, and filler so that keyframes are allowed.
struct KeyframedLog {
  Bytes file;
  std::vector<TimedDatagram> datagrams;
  std::uint64_t keyframes = 0;
};

inline KeyframedLog makeKeyframedLog(std::uint64_t seed, std::size_t count,
                                     const SessionState& preceding = {}) {
  KeyframedLog log;
  log.datagrams = randomDatagrams(seed, count);
  LogWriterOptions options;
  options.chunk_bytes = 8192;
  KeyframeOptions keyframes;
  keyframes.packets = 7;
  keyframes.span = std::chrono::milliseconds(500);
  SessionWriter session = makeSession(log.file, keyframes, options);
  EXPECT_TRUE(session.beginWith(preceding, log.datagrams.front().time).ok());
  const ChannelId spoken = *session.addChannel("/udp/1/x", "rk1", {});
  const ChannelId restated = *session.addChannel("/rocinante/restated/udp/1/x", "rk1", {});
  const ChannelId octets = *session.addChannel("/udp/1/127.0.0.1", "octets", {});
  const std::string filler(900, 'x');
  std::uint32_t number = 0;
  for (const TimedDatagram& said : log.datagrams) {
    const bool is_restated = said.text.find(" by=") != std::string::npos;
    const ChannelId channel = is_restated ? restated : spoken;
    EXPECT_TRUE(session.write(channel, number++, said.time, 0, bytesOf(said.text)).ok());
    for (int i = 0; i < 4; ++i) {
      EXPECT_TRUE(session.write(octets, number++, said.time, 0, bytesOf(filler)).ok());
    }
  }
  log.keyframes = session.keyframes();
  EXPECT_TRUE(session.log().close("finished").ok());
  return log;
}

}  // namespace rocinante::test
