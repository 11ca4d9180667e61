#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace rocinante::test {

/// Packet text of about 100 bytes, as a source of one six-joint arm sends it `rate_hz` times a
/// second: joints that move smoothly, to a hundred-thousandth of a radian.
inline std::string jointPacket(std::size_t sequence, double rate_hz) {
  const double time_s = static_cast<double>(sequence) / rate_hz;
  std::array<char, 256> text;
  std::size_t bytes = 0;
  const auto add = [&](const char* format, auto... values) {
    bytes += static_cast<std::size_t>(
        std::snprintf(text.data() + bytes, text.size() - bytes, format, values...));
  };
  add("RK1 arm@7f3a %zu %.6f\njoints arm", sequence, 1'770'091'506.0 + time_s);
  for (int joint = 0; joint < 6; ++joint) {
    add(" %.5f", 1.5 * std::sin(time_s * (0.3 + 0.17 * joint) + joint));
  }
  return std::string(text.data(), bytes) + "\n";
}

}  // namespace rocinante::test
