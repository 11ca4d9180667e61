// A datagram as an attacker would send it to a receiver that wants signatures, and as a sender
// might hand it to a signer: what is signed is believed, means what it meant, and is believed once.
#include <array>
#include <cstdlib>

#include "core/packet/packet_text.h"
#include "core/signing/trust_judge.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kNow = 1'700'000'000'250'000'001;

void require(bool holds) {
  if (!holds) std::abort();
}

SigningKey makeKey() {
  std::array<unsigned char, 32> seed{};
  for (std::size_t i = 0; i < seed.size(); ++i) seed[i] = static_cast<unsigned char>(i);
  return SigningKey::ofSeed(seed);
}

TrustFile makeTrust() {
  const SigningKey key = makeKey();
  TrustFile trust;
  trust.keys.push_back({key.id(), key.publicKey(), {"*"}, true});
  return trust;
}

std::size_t statementsOf(ByteView datagram, bool& is_packet) {
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(datagram);
  is_packet = packet != nullptr;
  return is_packet ? packet->statements.size() : 0;
}

void judgeTwice(ByteView datagram) {
  TrustJudge judge(makeTrust());
  const WallTime now{Nanoseconds(kNow)};
  const auto first = judge.judge(datagram, now);
  const auto second = judge.judge(datagram, now);
  require(second.has_value());
  require(second == (first ? *first : Untrusted::repeated));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView datagram(reinterpret_cast<const std::byte*>(data), size);
  judgeTwice(datagram);
  static DatagramSigner signer(makeKey(), [] { return WallTime(Nanoseconds(kNow)); });
  const ByteView made = signer.sign(datagram);
  bool was_packet = false;
  bool is_packet = false;
  const std::size_t statements = statementsOf(datagram, was_packet);
  if (made.empty()) {
    require(!was_packet);
    return 0;
  }
  require(made.size() <= size + kSignatureBytes);
  const ParsedSignature parsed = parseSignature(made);
  require(!parsed.fault);
  static const PublicKey key = makeKey().publicKey();
  std::string scratch;
  require(isSignedBy(key, parsed.datagram, scratch));
  require(statementsOf(made, is_packet) == statements && is_packet == was_packet);
  return 0;
}
