// A declared struct decoder beside one written by hand for the same packet: the real-time packet of
// a UR robot, six joints. Prints nanoseconds a datagram and the ratio.
#include <array>
#include <bit>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/packet/text_number.h"

namespace {

using namespace rocinante;

constexpr std::size_t kDatagrams = 64;
constexpr int kRounds = 20'000;
constexpr std::array<const char*, 6> kJoints{"shoulder_pan_joint", "shoulder_lift_joint",
                                             "elbow_joint",        "wrist_1_joint",
                                             "wrist_2_joint",      "wrist_3_joint"};

Bytes packet(std::size_t turn) {
  Bytes bytes(1108);
  bytes[2] = std::byte{0x04};
  bytes[3] = std::byte{0x54};
  for (std::size_t joint = 0; joint < 6; ++joint) {
    const double angle = 0.1234567 * static_cast<double>(turn * 6 + joint) - 3.0;
    const auto whole = std::bit_cast<std::uint64_t>(angle);
    for (std::size_t i = 0; i < 8; ++i) {
      bytes[252 + joint * 8 + i] = static_cast<std::byte>((whole >> (56 - 8 * i)) & 0xFFU);
    }
  }
  return bytes;
}

/// What a programmer would write for this packet alone.
bool decodeByHand(ByteView payload, std::int64_t time_ns, std::string& text) {
  if (payload.size() != 1108 || payload[2] != std::byte{0x04} || payload[3] != std::byte{0x54}) {
    return false;
  }
  text = "RK1 decoded:ur - ";
  appendSeconds(text, time_ns);
  text += "\njoint ur5";
  for (std::size_t joint = 0; joint < 6; ++joint) {
    std::uint64_t whole = 0;
    std::memcpy(&whole, payload.data() + 252 + joint * 8, 8);
    const auto angle = std::bit_cast<double>(__builtin_bswap64(whole));
    text += ' ';
    text += kJoints[joint];
    text += '=';
    appendNumber(text, angle);
  }
  return true;
}

template <class Work>
double nanosecondsEach(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < kDatagrams; ++i) work(i);
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / (static_cast<double>(kDatagrams) * kRounds);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "examples/decoders/ur_realtime.decoders.toml";
  auto decoders = decode::DatagramDecoders::open(file);
  if (!decoders) return std::fprintf(stderr, "%s\n", decoders.error().text().c_str()), 2;
  std::vector<Bytes> packets;
  for (std::size_t i = 0; i < kDatagrams; ++i) packets.push_back(packet(i));
  constexpr std::int64_t kTime = 1'700'000'000'250'000'000;
  const decode::Route route{30003, "10.0.0.5:30003", "/udp/30003/10.0.0.5"};
  std::string text;
  std::size_t bytes = 0;
  for (const Bytes& each : packets) {
    const decode::DecodedPacket* const made = decoders->decode(route, kTime, each);
    if (made == nullptr || !decodeByHand(each, kTime, text) || made->text != text) {
      std::fprintf(stderr, "the two decoders disagree\n");
      return 1;
    }
  }
  const double by_hand = nanosecondsEach([&](std::size_t i) {
    decodeByHand(packets[i], kTime, text);
    bytes += text.size();
  });
  const double declared = nanosecondsEach(
      [&](std::size_t i) { bytes += decoders->decode(route, kTime, packets[i])->text.size(); });
  std::printf("by hand %.0f ns, declared %.0f ns a datagram: %.2f times (%zu bytes)\n", by_hand,
              declared, declared / by_hand, bytes);
  return 0;
}
