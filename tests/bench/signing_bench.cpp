// What signing costs a datagram of a six-joint arm: signing it, judging it, and what is refused
// early, beside decoding and folding the same one unsigned. Prints nanoseconds a datagram and
// ratios of one run.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/signing/trust_judge.h"

namespace {

using namespace rocinante;

constexpr std::size_t kDatagrams = 2000;
constexpr std::int64_t kNow = 1'700'000'000'000'000'000;

SigningKey keyOf(unsigned char first) {
  std::array<unsigned char, 32> seed{};
  seed[0] = first;
  return SigningKey::ofSeed(seed);
}

std::vector<std::string> makeUnsigned() {
  std::vector<std::string> datagrams;
  for (std::size_t i = 0; i < kDatagrams; ++i) {
    datagrams.push_back("RK1 arm@7f3a " + std::to_string(i) + " 1700000000." +
                        std::to_string(100'000 + i) +
                        "\njoints arm 0.125431 -0.785398 1.570796 0.031250 0.523598 -2.094395\n");
  }
  return datagrams;
}

std::vector<std::string> signedBy(const std::vector<std::string>& datagrams, unsigned char first) {
  DatagramSigner signer(keyOf(first), [] { return WallTime(Nanoseconds(kNow)); });
  std::vector<std::string> made;
  for (const std::string& each : datagrams) {
    made.emplace_back(textOf(signer.sign(bytesOf(each))));
  }
  return made;
}

/// The best of five runs over all datagrams.
template <class Work>
double nanosecondsEach(Work work) {
  double best = 1e12;
  for (int run = 0; run < 5; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count() / static_cast<double>(kDatagrams));
  }
  return best;
}

TrustJudge makeJudge() {
  const SigningKey key = keyOf(1);
  TrustFile trust;
  trust.keys.push_back({key.id(), key.publicKey(), {"arm"}, false});
  return TrustJudge(std::move(trust));
}

double judging(const std::vector<std::string>& datagrams, std::uint64_t& trusted) {
  return nanosecondsEach([&] {
    TrustJudge judge = makeJudge();
    trusted = 0;
    for (const std::string& each : datagrams) {
      if (!judge.judge(bytesOf(each), WallTime(Nanoseconds(kNow)))) ++trusted;
    }
  });
}

}  // namespace

int main() {
  const std::vector<std::string> plain = makeUnsigned();
  const std::vector<std::string> good = signedBy(plain, 1);
  const double folding = nanosecondsEach([&] {
    PacketTextDecoder decoder;
    SessionState state;
    std::int64_t time = 0;
    for (const std::string& each : plain) {
      if (const Packet* packet = decoder.decode(bytesOf(each))) {
        state.apply(LogTime(Nanoseconds(++time)), *packet);
      }
    }
  });
  const double signing = nanosecondsEach([&] { signedBy(plain, 1); });
  std::vector<std::string> forged = good;
  for (std::string& each : forged) each[each.find("0.125431")] = '1';
  std::printf("%-32s %10s %8s %8s\n", "a six-joint datagram", "ns", "x fold", "trusted");
  const auto print = [&](const char* what, double ns, std::uint64_t trusted) {
    std::printf("%-32s %10.0f %8.1f %8llu\n", what, ns, ns / folding,
                static_cast<unsigned long long>(trusted));
  };
  print("decode and fold, unsigned", folding, 0);
  print("sign", signing, 0);
  std::uint64_t trusted = 0;
  double cost = judging(good, trusted);
  print("judge: trusted", cost, trusted);
  cost = judging(forged, trusted);
  print("judge: forged", cost, trusted);
  cost = judging(signedBy(plain, 2), trusted);
  print("judge: unknown key", cost, trusted);
  cost = judging(plain, trusted);
  print("judge: not signed", cost, trusted);
  return 0;
}
