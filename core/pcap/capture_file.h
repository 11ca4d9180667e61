#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/report/account.h"

namespace rocinante {

/// A frame of a capture file; its bytes are borrowed until the next call.
struct CapturedFrame {
  int link_type = 0;  ///< LINKTYPE number
  WallTime time{};
  ByteView bytes;
  std::size_t wire_bytes = 0;  ///< before the capture cut it
};

/// Reads capture files frame by frame: pcap (draft-ietf-opsawg-pcap; micro- and nanoseconds, both
/// byte orders) and pcapng (draft-ietf-opsawg-pcapng: several interfaces, also of different link
/// types, several sections, also of different byte orders). libpcap refuses those, so it reads no
/// files here (docs/decisions/035). Memory does not grow with the file. May be a pipe.
class CaptureFile {
 public:
  /// not_found; damaged when the first bytes are not those of a capture.
  static Result<CaptureFile> open(const std::string& path);

  /// Empty at the end. damaged where the file breaks off or breaks its rules.
  Result<std::optional<CapturedFrame>> next();

  /// The link type of the only interface, or of the first; known after the first frame.
  std::optional<int> firstLinkType() const;
  /// Frames of an interface that is not described: nobody knows what they are.
  std::uint64_t withoutInterface() const { return without_interface_; }
  /// What no frame has: times, blocks of unknown types, frames that the capturing program dropped.
  Account leftOut() const;

 private:
  struct Interface {
    int link_type = 0;
    std::uint32_t snap_bytes = 0;
    bool is_binary = false;  ///< units of 2^-exponent seconds, else of 10^-exponent
    unsigned exponent = 6;
    std::int64_t offset_s = 0;  ///< to be added to its times
    std::uint64_t dropped = 0;  ///< as its latest statistics have it
  };
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  explicit CaptureFile(std::FILE* file) : file_(file) {}

  Status readStart();
  Result<std::optional<CapturedFrame>> nextRecord();
  Result<std::optional<CapturedFrame>> nextBlock();
  enum class Packet { whole, without_interface, malformed };
  Packet readPacket(std::uint32_t type, ByteView body, CapturedFrame& frame);
  Status readSection();
  Status readInterface(ByteView body);
  void readStatistics(ByteView body);

  std::size_t read(std::size_t bytes);
  Error damage(std::string what) const;
  std::uint16_t two(ByteView bytes, std::size_t at) const;
  std::uint32_t four(ByteView bytes, std::size_t at) const;
  WallTime timeOf(const Interface& interface, std::uint64_t ticks) const;

  std::unique_ptr<std::FILE, Close> file_;
  bool is_ng_ = false, is_swapped_ = false;
  bool is_nano_ = false;  ///< of pcap
  unsigned minor_ = 4;    ///< of pcap's version 2
  Bytes block_;           ///< what was read last
  std::vector<Interface> interfaces_;
  std::uint64_t frames_ = 0;
  WallTime latest_{};
  std::uint64_t timeless_ = 0, without_interface_ = 0, dropped_before_ = 0;
  std::map<std::uint32_t, std::uint64_t> unknown_;  ///< blocks by type
};

}  // namespace rocinante
