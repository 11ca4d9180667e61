#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace rocinante::test {

/// What the kernel says of the sockets that are bound to a UDP port here.
struct UdpQueue {
  std::uint64_t waiting_bytes = 0;  ///< that nobody has taken yet
  std::uint64_t dropped = 0;        ///< because the buffer was full
};

/// Nothing where no socket is bound to `port`.
inline std::optional<UdpQueue> udpQueueAt(std::uint16_t port) {
  std::optional<UdpQueue> found;
  for (const char* const table : {"/proc/self/net/udp", "/proc/self/net/udp6"}) {
    std::ifstream file(table);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::istringstream words(line);
      std::vector<std::string> fields;
      for (std::string word; words >> word;) fields.push_back(word);
      // Number, own address, other address, state, sent:received ... drops.
      if (fields.size() < 13) continue;
      const auto behindColon = [](const std::string& text) {
        return std::stoull(text.substr(text.find(':') + 1), nullptr, 16);
      };
      if (behindColon(fields[1]) != port) continue;
      if (!found) found.emplace();
      found->waiting_bytes += behindColon(fields[4]);
      found->dropped += std::stoull(fields[12]);
    }
  }
  return found;
}

/// Waits until no more than `bytes` wait at `port`, so that a receiver that does not get to run has
/// nothing to lose. False when that takes a minute; a port that nobody holds holds nothing back.
inline bool waitUntilTaken(std::uint16_t port, std::uint64_t bytes = 0) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < give_up) {
    const std::optional<UdpQueue> queue = udpQueueAt(port);
    if (!queue || queue->waiting_bytes <= bytes) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace rocinante::test
