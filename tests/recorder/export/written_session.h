#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/log/log_writer.h"
#include "core/recording/session_writer.h"

namespace rocinante::test {

/// The origin of these sessions, nanoseconds since the epoch.
inline constexpr std::int64_t kWrittenOrigin = 1'700'000'000'000'000'000;

/// A datagram and when it came, nanoseconds after the origin.
struct Said {
  std::int64_t after_ns = 0;
  std::string text;
};

/// Writes a log of these datagrams, all on one channel.
inline void writeSession(const std::filesystem::path& path, std::span<const Said> all,
                         const KeyframeOptions& keyframes = {}) {
  LogWriterOptions options;
  options.overwrite = true;
  auto log = LogWriter::create(path, options, "session-1");
  ASSERT_TRUE(log.ok()) << log.error().text();
  log->setOrigin(LogTime(Nanoseconds(kWrittenOrigin)));
  SessionWriter session(std::move(*log), keyframes);
  const auto channel = session.addChannel(
      "/udp/test", "rk1",
      {{"local", "127.0.0.1:19960"}, {"remote", "127.0.0.1:4000"}, {"protocol", "udp"}});
  ASSERT_TRUE(channel.ok());
  std::uint32_t sequence = 0;
  for (const Said& said : all) {
    const std::int64_t time = kWrittenOrigin + said.after_ns;
    ASSERT_TRUE(
        session.write(*channel, sequence++, LogTime(Nanoseconds(time)), time, bytesOf(said.text))
            .ok());
  }
  ASSERT_TRUE(session.log().close("done").ok());
}

}  // namespace rocinante::test
