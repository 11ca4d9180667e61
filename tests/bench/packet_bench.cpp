// Decode + fold + publish of six-joint packets on one core, beside a bare loop that does nothing
// but std::from_chars over the same numbers. Prints nanoseconds a packet and ratios of one run.
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

namespace {

using namespace rocinante;

constexpr std::size_t kPackets = 200'000;
constexpr std::size_t kJoints = 6;

/// Velocity and effort of each joint.
constexpr std::size_t kSignals = 2 * kJoints;

std::vector<std::string> makePackets(std::size_t sources, bool with_signals) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle_rad(-3.14, 3.14);
  std::vector<std::string> packets;
  for (std::size_t i = 0; i < kPackets; ++i) {
    const std::string name = "arm" + std::to_string(i % sources);
    std::array<char, 256> line;
    int bytes = std::snprintf(line.data(), line.size(), "RK1 %s@7f3a %zu %zu.%06zu\njoints %s",
                              name.c_str(), i / sources, 1'700'000'000 + i / 6000, i % 6000 * 166,
                              name.c_str());
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      bytes += std::snprintf(line.data() + bytes, line.size() - static_cast<std::size_t>(bytes),
                             " %.6f", angle_rad(random));
    }
    std::string& packet = packets.emplace_back(line.data(), static_cast<std::size_t>(bytes));
    packet += '\n';
    if (!with_signals) continue;
    packet += "signals " + name;
    for (std::size_t signal = 0; signal < kSignals; ++signal) {
      std::snprintf(line.data(), line.size(), " joint_%zu.%s=%.6f", signal % kJoints + 1,
                    signal < kJoints ? "effort" : "velocity", angle_rad(random));
      packet += line.data();
    }
    packet += '\n';
  }
  return packets;
}

/// What a drawing thread would read: the newest joints, word by word.
struct Published {
  std::atomic<std::uint64_t> version{0};
  std::array<std::atomic<double>, kJoints> joints;

  void publish(std::span<const double> values) {
    version.fetch_add(1, std::memory_order_release);
    for (std::size_t i = 0; i < std::min(kJoints, values.size()); ++i) {
      joints[i].store(values[i], std::memory_order_relaxed);
    }
    version.fetch_add(1, std::memory_order_release);
  }
};

template <class Work>
double nanosecondsEach(Work work) {
  double best = 1e9;
  for (int run = 0; run < 7; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count() / static_cast<double>(kPackets));
  }
  return best;
}

double floorSum(const std::vector<std::string>& packets) {
  double sum = 0;
  for (const std::string& packet : packets) {
    const char* at = packet.data() + packet.find('\n') + 1;
    const char* const end = packet.data() + packet.size();
    for (int space = 0; space < 2; ++space) at = std::find(at, end, ' ') + 1;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      double value = 0;
      at = std::from_chars(at, end, value).ptr + 1;
      sum += value;
    }
    while ((at = std::find(at, end, '=')) != end) {
      double value = 0;
      at = std::from_chars(at + 1, end, value).ptr;
      sum += value;
    }
  }
  return sum;
}

void measure(std::size_t sources, bool with_signals) {
  const std::vector<std::string> packets = makePackets(sources, with_signals);
  double sum = 0;
  const double floor_ns = nanosecondsEach([&] { sum += floorSum(packets); });
  PacketTextDecoder decoder;
  const double header_ns = nanosecondsEach([&] {
    for (const std::string& packet : packets) {
      sum += static_cast<double>(decoder.decodeHeader(bytesOf(packet))->source.size());
    }
  });
  const double decode_ns = nanosecondsEach([&] {
    for (const std::string& packet : packets) {
      sum += decoder.decode(bytesOf(packet))->statements[0].numbers[0];
    }
  });
  std::vector<Published> published(sources);
  const double all_ns = nanosecondsEach([&] {
    SessionState state;
    std::size_t tick = 0;
    for (const std::string& packet : packets) {
      const Packet* const decoded = decoder.decode(bytesOf(packet));
      state.apply(LogTime(Nanoseconds(static_cast<std::int64_t>(tick))), *decoded);
      published[tick % sources].publish(decoded->statements[0].numbers);
      ++tick;
    }
  });
  std::printf(
      "%4zu sources%s: from_chars alone %.0f ns, decodeHeader %.0f (%.2fx), decode %.0f "
      "(%.2fx), decode + fold + publish %.0f (%.2fx) = %.1f M packets/s  [%g]\n",
      sources, with_signals ? ", twelve signals" : "", floor_ns, header_ns, header_ns / floor_ns,
      decode_ns, decode_ns / floor_ns, all_ns, all_ns / floor_ns, 1000 / all_ns, sum);
}

}  // namespace

int main() {
  std::printf("six-joint packets, ns a packet, best of 7\n");
  for (const std::size_t sources : {1U, 8U, 100U}) measure(sources, false);
  for (const std::size_t sources : {1U, 8U, 100U}) measure(sources, true);
}
