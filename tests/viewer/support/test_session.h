#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/log/log_writer.h"

namespace rocinante::test {

inline LogTime sessionTime(std::int64_t milliseconds) {
  return LogTime(std::chrono::seconds(1'700'000'000) + std::chrono::milliseconds(milliseconds));
}

/// Writes a log of packets by one source: (milliseconds from the origin, statements).
inline void writeSession(const std::filesystem::path& path,
                         const std::vector<std::pair<std::int64_t, std::string>>& packets) {
  auto writer = LogWriter::create(path, {}, "0123456789abcdef0123456789abcdef");
  ASSERT_TRUE(writer.has_value()) << writer.error().text();
  const auto channel = writer->addChannel("/udp/19960/robot", "rk1", {{"source", "robot"}});
  ASSERT_TRUE(channel.has_value());
  std::uint32_t sequence = 0;
  for (const auto& [milliseconds, statements] : packets) {
    const std::string text = "RK1 robot " + std::to_string(sequence) + " -\n" + statements;
    const LogTime time = sessionTime(milliseconds);
    ASSERT_TRUE(
        writer->write(*channel, sequence++, time, time.time_since_epoch().count(), bytesOf(text))
            .has_value());
  }
  ASSERT_TRUE(writer->close("test").has_value());
}

inline void writeText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// One arm that turns about z and carries a red box 1 m out.
inline constexpr const char* kArmUrdf = R"(<robot name="arm">
  <link name="base"/>
  <link name="hand">
    <visual><origin xyz="1 0 0.2"/><geometry><box size="0.4 0.2 0.2"/></geometry>
      <material name="red"><color rgba="0.9 0.1 0.1 1"/></material></visual>
  </link>
  <joint name="turn" type="continuous">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
  </joint>
</robot>
)";

/// The arm turning for 10 s, a packet each 100 ms; a line, a label and a view come on the way.
inline void writeArmSession(const std::filesystem::path& path) {
  std::vector<std::pair<std::int64_t, std::string>> packets;
  for (int i = 0; i <= 100; ++i) {
    std::string text = "joints arm " + std::to_string(i * 0.05) + "\n";
    if (i == 30) text += "line plan #ff8800 width=3 0 0 0.2 1 1 0.6 2 1 0.2\n";
    if (i == 40) text += "label here 1 1 0.6 \"the turn\"\n";
    if (i == 45) text += "view side 0 -5 1 0 0 0 40\n";
    if (i == 50) text += "color arm #2040ff\n";
    if (i == 70) text += "erase *\n";
    packets.emplace_back(i * 100, text);
  }
  writeSession(path, packets);
}

}  // namespace rocinante::test
