#include "core/pcap/capture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace rocinante {
namespace {

__extension__ using Wide = unsigned __int128;

// As libpcap: the largest frame that any supported link has, and the largest block.
constexpr std::size_t kMaxFrame = 262'144;
constexpr std::size_t kMaxBlock = std::size_t{16} << 20U;
constexpr std::size_t kMaxUnknown = 64;
// No capture is from before 1970 or after the year 2255; pcapng's times have a larger range than
// nanoseconds.
constexpr std::int64_t kMaxSeconds = 9'000'000'000;

enum Block : std::uint32_t {
  kSection = 0x0A0D0D0A,
  kInterface = 1,
  kOldPacket = 2,
  kSimplePacket = 3,
  kNames = 4,
  kStatistics = 5,
  kEnhancedPacket = 6,
  kSystemdJournal = 9,
  kSecrets = 10,
  kCustom = 0x00000BAD,
  kCustomUncopied = 0x40000BAD,
};

template <class T>
T numberAt(ByteView bytes, std::size_t at, bool swapped) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  if (!swapped) return value;
  if constexpr (sizeof value == 2) return __builtin_bswap16(value);
  if constexpr (sizeof value == 4) return __builtin_bswap32(value);
  return static_cast<T>(__builtin_bswap64(static_cast<std::uint64_t>(value)));
}

WallTime wallTime(std::int64_t seconds, std::int64_t nanoseconds) {
  return WallTime(std::chrono::seconds(std::clamp<std::int64_t>(seconds, 0, kMaxSeconds)) +
                  Nanoseconds(nanoseconds));
}

/// Calls `use(code, value)` for each option of a block, until one does not fit.
template <class Number, class Use>
void eachOption(ByteView options, const Number& two, const Use& use) {
  while (options.size() >= 4) {
    const std::size_t code = two(options, 0), length = two(options, 2);
    const std::size_t padded = (length + 3) / 4 * 4;
    if (code == 0 || options.size() - 4 < length) return;
    use(code, options.subspan(4, length));
    options = options.subspan(std::min(options.size(), 4 + padded));
  }
}

}  // namespace

Result<CaptureFile> CaptureFile::open(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Error{ErrorKind::not_found, "the capture file does not exist", {}};
  }
  std::FILE* const file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) {
    return Error{ErrorKind::unreadable,
                 fmt::format("the capture file cannot be read: {}", std::strerror(errno)),
                 {}};
  }
  CaptureFile capture(file);
  if (Status started = capture.readStart(); !started) return started.error();
  return capture;
}

/// Fills block_ with at most as many bytes; those that are there.
std::size_t CaptureFile::read(std::size_t bytes) {
  block_.resize(bytes);
  const std::size_t got = bytes == 0 ? 0 : std::fread(block_.data(), 1, bytes, file_.get());
  block_.resize(got);
  return got;
}

Error CaptureFile::damage(std::string what) const {
  return {ErrorKind::damaged,
          fmt::format("the capture ends early: {} behind frame {}", what, frames_),
          {}};
}

std::uint16_t CaptureFile::two(ByteView bytes, std::size_t at) const {
  return numberAt<std::uint16_t>(bytes, at, is_swapped_);
}
std::uint32_t CaptureFile::four(ByteView bytes, std::size_t at) const {
  return numberAt<std::uint32_t>(bytes, at, is_swapped_);
}

Status CaptureFile::readStart() {
  const auto refused = [](std::string why) {
    return Error{ErrorKind::damaged, "this is not a capture file: " + std::move(why), {}};
  };
  if (read(4) < 4) return refused("it ends in its header");
  const auto magic = numberAt<std::uint32_t>(block_, 0, false);
  if (magic == kSection) {
    is_ng_ = true;
    return readSection() ? Status{} : Status(refused("its section header is malformed"));
  }
  is_swapped_ = magic == 0xD4C3B2A1 || magic == 0x4D3CB2A1;
  const std::uint32_t own = is_swapped_ ? __builtin_bswap32(magic) : magic;
  is_nano_ = own == 0xA1B23C4D;
  if (!is_nano_ && own != 0xA1B2C3D4) return refused("unknown file format");
  if (read(20) < 20) return refused("it ends in its header");
  minor_ = two(block_, 2);
  if (two(block_, 0) != 2 || minor_ > 4) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("version {}.{} of capture files is not supported", two(block_, 0), minor_),
        {}};
  }
  Interface& only = interfaces_.emplace_back();
  only.link_type = static_cast<int>(four(block_, 16) & 0x03FFFFFFU);
  return {};
}

std::optional<int> CaptureFile::firstLinkType() const {
  if (interfaces_.empty()) return std::nullopt;
  return interfaces_.front().link_type;
}

Result<std::optional<CapturedFrame>> CaptureFile::next() {
  auto frame = is_ng_ ? nextBlock() : nextRecord();
  if (frame && *frame) ++frames_;
  return frame;
}

Result<std::optional<CapturedFrame>> CaptureFile::nextRecord() {
  const std::size_t got = read(16);
  if (got == 0) return std::optional<CapturedFrame>();
  if (got < 16) return damage("the file ends");
  const std::uint32_t seconds = four(block_, 0), part = four(block_, 4);
  std::size_t kept = four(block_, 8), wire = four(block_, 12);
  // Before version 2.3 the lengths were the other way round, in 2.3 sometimes.
  if (minor_ < 3 || (minor_ == 3 && kept > wire)) std::swap(kept, wire);
  if (kept > kMaxFrame) return damage(fmt::format("a frame of {} bytes", kept));
  if (read(kept) < kept) return damage("the file ends");
  CapturedFrame frame;
  frame.link_type = interfaces_.front().link_type;
  frame.time = wallTime(seconds, is_nano_ ? std::int64_t{part} : std::int64_t{part} * 1000);
  frame.bytes = block_;
  frame.wire_bytes = wire;
  return std::optional(frame);
}

Result<std::optional<CapturedFrame>> CaptureFile::nextBlock() {
  while (true) {
    const std::size_t got = read(4);
    if (got == 0) return std::optional<CapturedFrame>();
    if (got < 4) return damage("the file ends");
    const std::uint32_t type = four(block_, 0);
    if (type == kSection) {
      if (Status section = readSection(); !section) return section.error();
      continue;
    }
    if (read(4) < 4) return damage("the file ends");
    const std::uint32_t length = four(block_, 0);
    if (length < 12 || length % 4 != 0 || length > kMaxBlock) {
      return damage(fmt::format("a block of {} bytes", length));
    }
    if (read(length - 8) < length - 8) return damage("the file ends");
    const ByteView body = ByteView(block_).first(length - 12);
    if (four(block_, length - 12) != length) return damage("a block with two different lengths");
    switch (type) {
      case kInterface:
        if (Status known = readInterface(body); !known) return known.error();
        break;
      case kStatistics:
        readStatistics(body);
        break;
      case kEnhancedPacket:
      case kOldPacket:
      case kSimplePacket: {
        CapturedFrame frame;
        const Packet packet = readPacket(type, body, frame);
        if (packet == Packet::whole) return std::optional(frame);
        if (packet == Packet::malformed) return damage("a packet longer than its block");
        ++without_interface_;
        break;
      }
      case kNames:
      case kSystemdJournal:
      case kSecrets:
      case kCustom:
      case kCustomUncopied:
        break;
      default:
        // Beyond a limit all count as one: no block has the type 0.
        ++unknown_[unknown_.size() < kMaxUnknown || unknown_.contains(type) ? type : 0];
    }
  }
}

/// Behind its type.
Status CaptureFile::readSection() {
  if (read(8) < 8) return damage("the file ends");
  const auto magic = numberAt<std::uint32_t>(block_, 4, false);
  if (magic != 0x1A2B3C4D && magic != 0x4D3C2B1A) return damage("a malformed section header");
  // Each section has its own byte order.
  is_swapped_ = magic == 0x4D3C2B1A;
  const std::uint32_t length = four(block_, 0);
  if (length < 28 || length % 4 != 0 || length > kMaxBlock) {
    return damage(fmt::format("a section header of {} bytes", length));
  }
  if (read(length - 12) < length - 12) return damage("the file ends");
  if (two(block_, 0) != 1 || four(block_, length - 16) != length) {
    return damage("a section header of another version");
  }
  for (const Interface& each : interfaces_) dropped_before_ += each.dropped;
  interfaces_.clear();
  return {};
}

Status CaptureFile::readInterface(ByteView body) {
  if (body.size() < 8) return damage("an interface description that is too short");
  Interface interface;
  interface.link_type = two(body, 0);
  interface.snap_bytes = four(body, 4);
  const auto number = [this](ByteView bytes, std::size_t at) { return two(bytes, at); };
  eachOption(body.subspan(8), number, [&](std::size_t code, ByteView value) {
    if (code == 9 && value.size() == 1) {
      const auto resolution = std::to_integer<unsigned>(value[0]);
      interface.is_binary = (resolution & 0x80U) != 0;
      interface.exponent = resolution & 0x7FU;
    }
    if (code == 14 && value.size() == 8) {
      interface.offset_s = numberAt<std::int64_t>(value, 0, is_swapped_);
    }
  });
  if (interface.exponent > (interface.is_binary ? 63U : 19U)) {
    return damage("an interface with a time resolution that is not supported");
  }
  interfaces_.push_back(interface);
  return {};
}

void CaptureFile::readStatistics(ByteView body) {
  if (body.size() < 12 || four(body, 0) >= interfaces_.size()) return;
  std::uint64_t dropped = 0;
  const auto number = [this](ByteView bytes, std::size_t at) { return two(bytes, at); };
  eachOption(body.subspan(12), number, [&](std::size_t code, ByteView value) {
    // isb_ifdrop and isb_osdrop
    if ((code == 5 || code == 7) && value.size() == 8) {
      dropped += numberAt<std::uint64_t>(value, 0, is_swapped_);
    }
  });
  interfaces_[four(body, 0)].dropped = dropped;
}

CaptureFile::Packet CaptureFile::readPacket(std::uint32_t type, ByteView body,
                                            CapturedFrame& frame) {
  const bool is_simple = type == kSimplePacket;
  const std::size_t header = is_simple ? 4 : 20;
  if (body.size() < header) return Packet::malformed;
  std::size_t number = 0;
  if (type == kEnhancedPacket) number = four(body, 0);
  if (type == kOldPacket) number = two(body, 0);
  if (number >= interfaces_.size()) return Packet::without_interface;
  const Interface& interface = interfaces_[number];
  frame.link_type = interface.link_type;
  frame.wire_bytes = four(body, is_simple ? 0 : 16);
  std::size_t kept =
      is_simple ? std::min(frame.wire_bytes, body.size() - header) : std::size_t{four(body, 12)};
  if (is_simple && interface.snap_bytes > 0)
    kept = std::min<std::size_t>(kept, interface.snap_bytes);
  if (kept > body.size() - header || kept > kMaxFrame) return Packet::malformed;
  frame.bytes = body.subspan(header, kept);
  if (is_simple) {
    ++timeless_;
  } else {
    latest_ = timeOf(interface, std::uint64_t{four(body, 4)} << 32U | four(body, 8));
  }
  frame.time = latest_;
  return Packet::whole;
}

WallTime CaptureFile::timeOf(const Interface& interface, std::uint64_t ticks) const {
  std::uint64_t a_second = std::uint64_t{1} << (interface.is_binary ? interface.exponent : 0U);
  for (unsigned i = 0; i < interface.exponent && !interface.is_binary; ++i) a_second *= 10;
  // A second of 1 tick has up to 2^64 of them: beyond every offset.
  const auto seconds =
      static_cast<std::int64_t>(std::min<std::uint64_t>(ticks / a_second, std::uint64_t{1} << 62U));
  const Wide part = Wide{ticks % a_second} * 1'000'000'000 / a_second;
  const std::int64_t offset =
      std::clamp(interface.offset_s, -(std::int64_t{1} << 62), std::int64_t{1} << 61);
  return wallTime(seconds + offset, static_cast<std::int64_t>(part));
}

Account CaptureFile::leftOut() const {
  Account account;
  const auto leaveOut = [&](std::uint64_t count, const char* kind, std::string name,
                            const char* reason, Severity severity) {
    if (count == 0) return;
    account.leaveOut({.kind = kind,
                      .name = std::move(name),
                      .reason = reason,
                      .count = count,
                      .severity = severity});
  };
  leaveOut(timeless_, "time", {}, "simple packet blocks have none: they get the one before",
           Severity::warning);
  leaveOut(without_interface_, "frame", {}, "its interface is not described", Severity::warning);
  std::uint64_t dropped = dropped_before_;
  for (const Interface& each : interfaces_) dropped += each.dropped;
  leaveOut(dropped, "frame", {}, "the capturing program dropped them", Severity::warning);
  for (const auto& [type, count] : unknown_) {
    leaveOut(count, "block", type == 0 ? "others" : fmt::format("{:#010x}", type),
             "of an unknown type", Severity::note);
  }
  return account;
}

}  // namespace rocinante
