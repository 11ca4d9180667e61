#include "core/signing/signed_datagram.h"

#include <gtest/gtest.h>

#include "core/packet/packet_text.h"
#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

using test::kSignedKeep;
using test::kSignedPacket;
using test::kUnsignedPacket;
using test::kVectorAt;
using test::signedText;
using test::vectorKey;

/// Whether a stranger who has the key's public half believes the datagram.
bool isBelieved(std::string_view datagram) {
  const ParsedSignature parsed = parseSignature(bytesOf(datagram));
  std::string scratch;
  return !parsed.fault && parsed.datagram.key == vectorKey().id() &&
         isSignedBy(vectorKey().publicKey(), parsed.datagram, scratch);
}

std::string faultOf(std::string_view datagram) {
  const ParsedSignature parsed = parseSignature(bytesOf(datagram));
  return parsed.fault ? std::string(nameOf(*parsed.fault)) : "none";
}

TEST(SignedDatagram, HasTheBytesOfTheVector) {
  EXPECT_EQ(signedText(kUnsignedPacket), kSignedPacket);
  EXPECT_EQ(signedText("RKS1 keep id=00000000000000ff\n", kVectorAt + 1), kSignedKeep);
  EXPECT_TRUE(isBelieved(kSignedPacket));
  EXPECT_TRUE(isBelieved(kSignedKeep));
}

TEST(SignedDatagram, IsTakenApart) {
  const SignedDatagram apart = parseSignature(bytesOf(kSignedPacket)).datagram;
  EXPECT_EQ(apart.header, "RK1 arm@7f3a 41 1700000000.25 at=1700000000250000001");
  EXPECT_TRUE(apart.is_packet);
  EXPECT_EQ(apart.at_ns, kVectorAt);
  EXPECT_EQ(keyIdText(apart.key), test::kVectorId);
  EXPECT_TRUE(apart.text.ends_with("1.57\n"));
  EXPECT_FALSE(parseSignature(bytesOf(kSignedKeep)).datagram.is_packet);
}

TEST(SignedDatagram, EveryFlippedBitIsRefused) {
  for (const std::string_view whole : {kSignedPacket, kSignedKeep}) {
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
      std::string flipped(whole);
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
      EXPECT_FALSE(isBelieved(flipped)) << "bit " << bit;
    }
  }
}

TEST(SignedDatagram, EveryCutAndEveryAddedByteIsRefused) {
  for (std::size_t bytes = 0; bytes < kSignedPacket.size(); ++bytes) {
    // A copy of its own, so that a byte too many is read outside of it.
    const std::vector<char> cut(kSignedPacket.begin(),
                                kSignedPacket.begin() + static_cast<std::ptrdiff_t>(bytes));
    EXPECT_FALSE(isBelieved({cut.data(), cut.size()})) << bytes;
  }
  for (const std::string_view added : {"\n", " ", "#", "# comment\n", "joints puma 1\n"}) {
    EXPECT_FALSE(isBelieved(std::string(kSignedPacket) + std::string(added)));
    EXPECT_FALSE(isBelieved(std::string(added) + std::string(kSignedPacket)));
  }
  EXPECT_FALSE(isBelieved(std::string(kSignedPacket) + '\0'));
}

TEST(SignedDatagram, MeansTheSameToAReaderThatDoesNotVerify) {
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(kSignedPacket));
  ASSERT_NE(packet, nullptr);
  EXPECT_TRUE(packet->faults.empty());
  EXPECT_EQ(packet->statements.size(), 1U);
  EXPECT_EQ(packet->header.source, "arm");
}

TEST(SignedDatagram, WhatIsNotSignedAndWhatIsMalformedAreToldApart) {
  EXPECT_EQ(faultOf(""), "not_signed");
  EXPECT_EQ(faultOf(kUnsignedPacket), "not_signed");
  EXPECT_EQ(faultOf("octets"), "not_signed");
  const std::string line(kSignedPacket.substr(kSignedPacket.rfind("sig ")));
  EXPECT_EQ(faultOf(line), "not_signed");
  EXPECT_EQ(faultOf("octets\n" + line), "not_signed");
  EXPECT_EQ(faultOf("RK2 arm - - at=1\n" + line), "not_signed");
  EXPECT_EQ(faultOf("RK1 arm - - at=1\nsig k1 bm90\n"), "malformed");
  EXPECT_EQ(faultOf("RK1 arm - - at=1\n" + line), "none");
  EXPECT_EQ(faultOf("RK1 arm - -\n" + line), "malformed");
  EXPECT_EQ(faultOf("RK1 arm - - at=1 restated\n" + line), "malformed");
  EXPECT_EQ(faultOf("RK1 arm - - at=\n" + line), "malformed");
  EXPECT_EQ(faultOf("RK1 arm - - at=-1\n" + line), "malformed");
  EXPECT_EQ(faultOf("RK1 arm - - at=9223372036854775807\n" + line), "none");
  EXPECT_EQ(faultOf("RK1 arm - - at=9223372036854775808\n" + line), "malformed");
  std::string upper = line;
  upper[4 + 1] = 'D';
  EXPECT_EQ(faultOf("RK1 arm - - at=1\n" + upper), "malformed");
}

TEST(DatagramSigner, KeepsCommentsCarriageReturnsAndAMissingLineFeed) {
  for (const std::string_view text : {"# first\n\n \tRK1 arm 1 - restated \t\r\njoints a 1\r\n",
                                      "RK1 arm 1 -", "RK1 arm 1 -\njoints a 1"}) {
    SCOPED_TRACE(text);
    const std::string made = signedText(text);
    EXPECT_TRUE(isBelieved(made)) << made;
    EXPECT_LE(made.size(), text.size() + kSignatureBytes);
  }
  EXPECT_TRUE(signedText(std::string("RK1 arm 1 -\n\0\0", 14)).find('\0') == std::string::npos);
}

TEST(DatagramSigner, ReplacesAnEarlierSignature) {
  const std::string again = signedText(kSignedPacket, kVectorAt);
  EXPECT_EQ(again, kSignedPacket);
  const std::string by_another = signedText(kSignedPacket, kVectorAt, 1);
  EXPECT_EQ(by_another.size(), kSignedPacket.size());
  EXPECT_FALSE(isBelieved(by_another));
}

TEST(DatagramSigner, SignsNothingElse) {
  for (const std::string_view text : {"", "\n", "octets", "RK12 a", "sig x y\n"}) {
    EXPECT_EQ(signedText(text), "");
  }
}

TEST(DatagramSigner, ItsTimesRiseAlthoughTheClockIsSetBack) {
  std::int64_t now = 1000;
  DatagramSigner signer(vectorKey(), [&] { return test::wallAt(now); });
  const auto atOf = [&] {
    return parseSignature(signer.sign(bytesOf(kUnsignedPacket))).datagram.at_ns;
  };
  EXPECT_EQ(atOf(), 1000);
  EXPECT_EQ(atOf(), 1001);
  now = 10;
  EXPECT_EQ(atOf(), 1002);
  now = 5000;
  EXPECT_EQ(atOf(), 5000);
}

TEST(DatagramSigner, NeverAddsMoreThanItSays) {
  const std::string longest = signedText("RK1 a - -", 9'223'372'036'854'775'806);
  EXPECT_EQ(longest.size(), std::string_view("RK1 a - -").size() + kSignatureBytes);
}

}  // namespace
}  // namespace rocinante
