#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/log_writer.h"

namespace rocinante::test {

/// One message as a test writes it down.
struct WrittenMessage {
  Nanoseconds time{};
  std::string payload;
  std::string topic = "/udp/1/a";  ///< /rocinante/... is not captured
};

/// Writes a log of packet text in `path`; every topic is a channel of source "a".
inline std::filesystem::path writeLog(const std::filesystem::path& path,
                                      const std::vector<WrittenMessage>& messages) {
  auto writer = LogWriter::create(path, LogWriterOptions(), "session").value();
  std::map<std::string, ChannelId> channels;
  std::uint32_t sequence = 0;
  for (const WrittenMessage& message : messages) {
    if (!channels.contains(message.topic)) {
      channels[message.topic] =
          writer
              .addChannel(message.topic, "rk1",
                          {{"source", message.topic.substr(message.topic.rfind('/') + 1)}})
              .value();
    }
    EXPECT_TRUE(writer
                    .write(channels[message.topic], sequence++, LogTime(message.time),
                           message.time.count(), bytesOf(message.payload))
                    .ok());
  }
  EXPECT_TRUE(writer.close("test").ok());
  return path;
}

}  // namespace rocinante::test
