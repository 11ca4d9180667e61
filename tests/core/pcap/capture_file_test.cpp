#include "core/pcap/capture_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/pcap/pcap_source.h"
#include "tests/core/pcap/frames.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::ethernetFrame;
using test::FrameBytes;
using test::ipPackets;
using test::Sent;
using test::sent;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// Writes pcapng in either byte order.
class CaptureBlocks {
 public:
  explicit CaptureBlocks(bool is_big) : is_big_(is_big) {}

  CaptureBlocks& section() {
    Bytes body;
    add(body, 0x1A2B3C4D, 4);
    add(body, 1, 2);
    add(body, 0, 2);
    add(body, ~std::uint64_t{0}, 8);
    return block(0x0A0D0D0A, body);
  }
  CaptureBlocks& interface(unsigned link_type, const Bytes& options = {}) {
    Bytes body;
    add(body, link_type, 2);
    add(body, 0, 2);
    add(body, 0, 4);
    body.insert(body.end(), options.begin(), options.end());
    return block(1, body);
  }
  CaptureBlocks& packet(unsigned number, std::uint64_t ticks, const Bytes& frame) {
    Bytes body;
    for (const std::uint64_t each : {std::uint64_t{number}, ticks >> 32U, ticks & 0xFFFFFFFFU,
                                     std::uint64_t{frame.size()}, std::uint64_t{frame.size()}}) {
      add(body, each, 4);
    }
    body.insert(body.end(), frame.begin(), frame.end());
    return block(6, body);
  }
  CaptureBlocks& simple(const Bytes& frame) {
    Bytes body;
    add(body, frame.size(), 4);
    body.insert(body.end(), frame.begin(), frame.end());
    return block(3, body);
  }
  CaptureBlocks& block(std::uint32_t type, Bytes body) {
    body.resize((body.size() + 3) / 4 * 4);
    add(bytes_, type, 4);
    add(bytes_, body.size() + 12, 4);
    bytes_.insert(bytes_.end(), body.begin(), body.end());
    add(bytes_, body.size() + 12, 4);
    return *this;
  }
  Bytes option(unsigned code, std::uint64_t value, unsigned size) const {
    Bytes option;
    add(option, code, 2);
    add(option, size, 2);
    add(option, value, size);
    option.resize((option.size() + 3) / 4 * 4);
    return option;
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  void add(Bytes& to, std::uint64_t value, unsigned size) const {
    for (unsigned i = 0; i < size; ++i) {
      const unsigned shift = (is_big_ ? size - 1 - i : i) * 8;
      to.push_back(static_cast<std::byte>(value >> shift));
    }
  }

  bool is_big_;
  Bytes bytes_;
};

const Sent kOfFile = sent("10.0.0.1", 4'000, "10.0.0.2", 5'000, "first");

struct FileRead {
  std::vector<std::string> datagrams;  ///< times and payloads
  Account left_out;
  std::string trouble;
};

FileRead readBytes(const Bytes& bytes) {
  const TemporaryFolder folder;
  const std::string path = (folder / "x.pcapng").string();
  std::ofstream(path, std::ios::binary) << textOf(bytes);
  Endpoint endpoint;
  endpoint.scheme = Endpoint::Scheme::pcap;
  endpoint.file = path;
  FileRead outcome;
  const auto source = openPcap(endpoint, {});
  if (!source) {
    outcome.trouble = source.error().text();
    return outcome;
  }
  while (!(*source)->ended()) {
    const auto batch = (*source)->receive();
    if (!batch) {
      outcome.trouble = batch.error().text();
      break;
    }
    for (const ReceivedDatagram& each : *batch) {
      outcome.datagrams.push_back(std::to_string(each.kernel_time.time_since_epoch().count()) +
                                  " " + std::string(textOf(each.payload)));
    }
  }
  outcome.left_out = (*source)->leftOut();
  return outcome;
}

TEST(CaptureFile, ReadsInterfacesOfSeveralLinkTypesAndResolutions) {
  const Bytes packet = ipPackets(kOfFile).at(0);
  for (const bool is_big : {false, true}) {
    CaptureBlocks file(is_big);
    file.section().interface(1).interface(101, file.option(9, 9, 1));
    file.interface(101, file.option(9, 0x80 | 10, 1)).interface(1, file.option(14, 100, 8));
    file.packet(0, 5'000'001, ethernetFrame(packet)).packet(1, 6'000'000'007, packet);
    file.packet(2, 7 * 1024 + 512, packet).packet(3, 8'000'000, ethernetFrame(packet, {7}));
    const FileRead outcome = readBytes(file.bytes());
    EXPECT_THAT(outcome.datagrams, ElementsAre("5000001000 first", "6000000007 first",
                                               "7500000000 first", "108000000000 first"));
    EXPECT_TRUE(outcome.left_out.empty()) << accountSentence(outcome.left_out);
    EXPECT_EQ(outcome.trouble, "");
  }
}

TEST(CaptureFile, EachSectionHasItsByteOrderAndItsInterfaces) {
  const Bytes packet = ipPackets(kOfFile).at(0);
  Bytes all =
      CaptureBlocks(false).section().interface(1).packet(0, 1, ethernetFrame(packet)).bytes();
  const Bytes second = CaptureBlocks(true).section().interface(101).packet(0, 2, packet).bytes();
  all.insert(all.end(), second.begin(), second.end());
  const FileRead outcome = readBytes(all);
  EXPECT_THAT(outcome.datagrams, ElementsAre("1000 first", "2000 first"));
  EXPECT_EQ(outcome.trouble, "");
}

TEST(CaptureFile, NamesWhatItCannotUse) {
  const Bytes frame = ethernetFrame(ipPackets(kOfFile).at(0));
  CaptureBlocks file(false);
  file.section().interface(1).interface(147).packet(0, 9, frame).packet(1, 9, frame);
  file.packet(7, 9, frame).simple(frame).block(0x1234, Bytes(8));
  Bytes statistics(12);
  const Bytes dropped = file.option(5, 3, 8);
  statistics.insert(statistics.end(), dropped.begin(), dropped.end());
  file.block(5, statistics);
  const FileRead outcome = readBytes(file.bytes());
  EXPECT_THAT(outcome.datagrams, ElementsAre("9000 first", "9000 first"));
  EXPECT_EQ(accountSentence(outcome.left_out, 9),
            "left out: 1 frame `link type 147` (not supported; at frame 2), "
            "1 time (simple packet blocks have none: they get the one before), "
            "1 frame (its interface is not described), "
            "3 frames (the capturing program dropped them), "
            "1 block `0x00001234` (of an unknown type)");
}

// Whatever is inserted or removed, the datagrams change, or the account does.
TEST(CaptureFile, WhatIsInsertedIsUsedOrNamed) {
  const Bytes good = ethernetFrame(ipPackets(kOfFile).at(0));
  const auto readFrames = [](const std::vector<Bytes>& frames) {
    CaptureBlocks file(false);
    file.section().interface(1);
    for (const Bytes& frame : frames) file.packet(0, 1, frame);
    const FileRead outcome = readBytes(file.bytes());
    return std::pair(outcome.datagrams, accountSentence(outcome.left_out));
  };
  Bytes tcp = good, cut = good, options = good, fragment = good;
  tcp[23] = std::byte{6};
  cut.resize(20);
  options.push_back(std::byte{7});
  options[17] = static_cast<std::byte>(std::to_integer<unsigned>(options[17]) + 1);
  fragment[20] = std::byte{0x20};
  fragment.resize(14 + 20 + 8);
  fragment[17] = std::byte{28};
  const std::vector<Bytes> inserted = {
      tcp,
      cut,
      options,
      fragment,
      Bytes(),
      Bytes(60),
      FrameBytes().number(0, 12).number(0x0806, 2).number(0, 28).take(),
      FrameBytes().number(0, 12).number(0x88B5, 2).number(0, 28).take(),
      FrameBytes().number(0, 12).number(0x0026, 2).number(0, 38).take()};
  const std::vector<Bytes> whole = {good, good};
  const auto before = readFrames(whole);
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    for (std::ptrdiff_t place = 0; place <= 2; ++place) {
      SCOPED_TRACE(std::to_string(i) + " at " + std::to_string(place));
      std::vector<Bytes> frames = whole;
      frames.insert(frames.begin() + place, inserted[i]);
      EXPECT_NE(readFrames(frames), before);
    }
  }
  EXPECT_NE(readFrames({good}), before);
}

TEST(CaptureFile, EveryCutIsRefusedOrReadUpToThere) {
  const Bytes frame = ethernetFrame(ipPackets(kOfFile).at(0));
  CaptureBlocks file(false);
  file.section().interface(1).packet(0, 1, frame).packet(0, 2, frame);
  const std::size_t whole = file.bytes().size();
  for (std::size_t size = 0; size < whole; ++size) {
    SCOPED_TRACE(size);
    const FileRead outcome = readBytes(
        Bytes(file.bytes().begin(), file.bytes().begin() + static_cast<std::ptrdiff_t>(size)));
    EXPECT_LE(outcome.datagrams.size(), 1U);
    const std::size_t packet = 32 + (frame.size() + 3) / 4 * 4;
    const bool between = size == 28 || size == 48 || size == 48 + packet;
    EXPECT_EQ(outcome.trouble.empty(), between) << outcome.trouble;
  }
}

TEST(CaptureFile, BelievesNoLength) {
  const Bytes frame = ethernetFrame(ipPackets(kOfFile).at(0));
  for (const std::uint32_t lie : {0U, 8U, 13U, 0x7FFFFFFCU, 0xFFFFFFFFU}) {
    CaptureBlocks file(false);
    file.section().interface(1).packet(0, 1, frame);
    Bytes bytes = file.bytes();
    std::memcpy(bytes.data() + 48 + 4, &lie, 4);  // of the packet's block
    EXPECT_THAT(readBytes(bytes).trouble, HasSubstr("the capture ends early"));
    bytes = file.bytes();
    std::memcpy(bytes.data() + 48 + 20, &lie, 4);  // of the bytes kept of the frame
    const FileRead outcome = readBytes(bytes);
    EXPECT_TRUE(outcome.datagrams.empty());
    EXPECT_TRUE(!outcome.trouble.empty() || !outcome.left_out.empty());
  }
}

}  // namespace
}  // namespace rocinante
