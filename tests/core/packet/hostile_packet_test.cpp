// Datagrams are not trusted: every cut and every flipped bit is read without harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/core/packet/fold_text.h"
#include "tests/core/packet/random_session.h"

namespace rocinante {
namespace {

/// Decodes and folds a copy of exactly its length, so that a sanitizer sees one byte too many.
void readCopy(std::string_view bytes, SessionState& state, PacketTextDecoder& decoder) {
  const auto copy = std::make_unique<char[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), copy.get());
  const ByteView datagram = bytesOf({copy.get(), bytes.size()});
  const bool has_header = decoder.decodeHeader(datagram) != nullptr;
  const Packet* const packet = decoder.decode(datagram);
  EXPECT_EQ(packet != nullptr, has_header);
  if (packet == nullptr) {
    EXPECT_EQ(decoder.faults().size(), 1U);
    return;
  }
  EXPECT_EQ(encodingOf(datagram), "rk1");
  state.apply(test::atSeconds(1), *packet);
}

constexpr std::string_view kEverything =
    "\tRK1 m%C3%A9@7f 18446744073709551615 12.123456789 restated part=a:1/2 by=r reset via=r:1\r\n"
    "joints arm 1e-3 -12345678901234567890.5 .5 5.\norder arm a%20b c\njoint arm a=1 b=-2e5\n"
    "pose p 1 2 3 0 0 3 4 in arm/l%2F1\nadd arm puma kin=00ff00ff00ff00ff\nremove tank\n"
    "show arm/l1 default\nhide layer/x\ncolor arm #ff000080\n"
    "line p:1/2 #ff0000 width=2 in arm/l 1 2 3 4 5 6\npoints q #ff0000 size=2 1 2 3\n"
    "label n in arm/l 1 2 3 \"a\\\"\\\\\\n\xF0\x9F\xA6\xBE\"\nerase p\nerase *\nevent "
    "\"\xC3\xA9\"\n"
    "view v 1 2 3 4 5 6 45 up 0 1 0 ortho 2 in arm/l\nseen arm 123\nsig k YWJj\n";

TEST(HostilePacket, EveryCutIsRead) {
  PacketTextDecoder decoder;
  SessionState state;
  for (std::size_t length = 0; length <= kEverything.size(); ++length) {
    readCopy(kEverything.substr(0, length), state, decoder);
    readCopy(kEverything.substr(length), state, decoder);
  }
}

TEST(HostilePacket, EveryLineCutAtEveryByteHarmsThatLineAlone) {
  PacketTextDecoder decoder;
  std::string_view rest = kEverything.substr(kEverything.find('\n') + 1);
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size() + 1);
    for (std::size_t length = 0; length < line.size(); ++length) {
      const std::string text =
          "RK1 m - -\nremove first\n" + std::string(line.substr(0, length)) + "\nremove last\n";
      const Packet* const packet = decoder.decode(bytesOf(text));
      ASSERT_NE(packet, nullptr);
      ASSERT_GE(packet->statements.size(), 2U) << text;
      EXPECT_EQ(packet->statements.front().name, "first") << text;
      EXPECT_EQ(packet->statements.back().name, "last") << text;
      EXPECT_LE(packet->statements.size() + packet->faults.size(), 4U) << text;
    }
  }
}

TEST(HostilePacket, EveryFlippedBitIsRead) {
  PacketTextDecoder decoder;
  SessionState state;
  std::string bytes(kEverything);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      const char before = bytes[i];
      bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
      readCopy(bytes, state, decoder);
      bytes[i] = before;
    }
  }
}

TEST(HostilePacket, RandomBytesAndShuffledSessionsAreRead) {
  std::mt19937_64 random(3);
  PacketTextDecoder decoder;
  SessionState state;
  test::RandomSession session(5);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = session.next().text;
    for (int edit = 0; edit < 3; ++edit) {
      const std::size_t at = random() % bytes.size();
      if (random() % 2 == 0) {
        bytes[at] = static_cast<char>(random());
      } else {
        std::rotate(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end());
        bytes.insert(0, "RK1 a - -\n");
      }
    }
    readCopy(bytes, state, decoder);
  }
}

TEST(HostilePacket, LongLinesAndManyLinesTakeLinearTime) {
  PacketTextDecoder decoder;
  SessionState state;
  readCopy(std::string(1 << 20, ' '), state, decoder);
  readCopy(std::string(1 << 20, '\n'), state, decoder);
  readCopy(std::string(1 << 20, '\0'), state, decoder);
  readCopy("RK1 " + std::string(1 << 20, 'a'), state, decoder);
  readCopy("RK1 a - - " + std::string(1 << 20, 'w'), state, decoder);
  std::string words = "RK1 a - -";
  std::string lines = "RK1 a - -\n";
  for (int i = 0; i < 1 << 18; ++i) {
    words += " w=1";
    lines += "sig\n";
  }
  readCopy(words, state, decoder);
  readCopy(lines, state, decoder);
  EXPECT_EQ(decoder.faults().size(), (1U << 18U) - 1);
}

}  // namespace
}  // namespace rocinante
