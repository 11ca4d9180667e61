#pragma once

#include <cstdint>
#include <memory>

#include "core/mcap/byte_sink.h"
#include "core/mcap/tail_reserve.h"

namespace rocinante::mcap {

/// The data section of a file as far as it is written: its size, its checksum, and the room
/// reserved behind it for the file's end. An append is written whole or not at all.
class GrowingFile {
 public:
  explicit GrowingFile(std::unique_ptr<ByteSink> sink);

  std::uint64_t size() const { return size_; }
  /// The checksum of everything appended and counted.
  std::uint32_t crc() const { return crc_; }
  bool overwritable() const { return sink_->overwritable(); }
  const std::string& name() const { return sink_->name(); }

  /// Appends `bytes` if `tail_bytes` more still fit behind them; otherwise leaves the file
  /// unchanged.
  Status append(ByteView bytes, std::uint64_t tail_bytes);
  /// The same for bytes that are added to the checksum later, by count().
  Status appendUncounted(ByteView bytes, std::uint64_t tail_bytes);
  /// Adds the checksum of the next bytes, in file order.
  void count(std::uint32_t crc, std::uint64_t size_bytes);

  /// Overwrites uncounted bytes.
  Status overwrite(std::uint64_t offset, ByteView bytes);
  /// From `offset` to the end nothing changes any more: the system may write it to the disk.
  Status settle(std::uint64_t offset);
  Status check() { return sink_->check(); }
  Status close() { return sink_->close(); }

 private:
  std::unique_ptr<ByteSink> sink_;
  TailReserve reserve_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
  bool torn_ = false;  ///< the end holds part of an append that could not be removed
};

}  // namespace rocinante::mcap
