#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/log/log_writer.h"

namespace rocinante::test {

struct Spoken {
  std::int64_t milliseconds = 0;
  std::string packet;
};

inline LogTime spokenTime(std::int64_t milliseconds) {
  return LogTime(std::chrono::seconds(1'700'000'000) + std::chrono::milliseconds(milliseconds));
}

/// Writes a log of whole packets.
inline void writeSpoken(const std::filesystem::path& path, const std::vector<Spoken>& packets) {
  auto writer = LogWriter::create(path, {}, "0123456789abcdef0123456789abcdef");
  ASSERT_TRUE(writer.has_value());
  const auto channel = writer->addChannel("/udp/19960/robot", "rk1", {});
  ASSERT_TRUE(channel.has_value());
  std::uint32_t number = 0;
  for (const Spoken& spoken : packets) {
    const LogTime time = spokenTime(spoken.milliseconds);
    ASSERT_TRUE(writer->write(*channel, number++, time, nanosecondsOf(time), bytesOf(spoken.packet))
                    .has_value());
  }
  ASSERT_TRUE(writer->close("test").has_value());
}

}  // namespace rocinante::test
