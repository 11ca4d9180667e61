#pragma once

#include <cstdint>
#include <memory>

#include "core/mcap/byte_sink.h"
#include "core/mcap/tail_reserve.h"

namespace rocinante::mcap {

/// The data section of a file as far as it is written: how far that is, its checksum, and room kept
/// behind it for the file's end. What is appended stands there whole or not at all.
class GrowingFile {
 public:
  explicit GrowingFile(std::unique_ptr<ByteSink> sink);

  std::uint64_t size() const { return size_; }
  /// Of all that was appended and counted.
  std::uint32_t crc() const { return crc_; }
  bool overwritable() const { return sink_->overwritable(); }
  const std::string& name() const { return sink_->name(); }

  /// Appends `bytes`, provided that `tail_bytes` more still fit behind them; else leaves the file
  /// as it was.
  Status append(ByteView bytes, std::uint64_t tail_bytes);
  /// The same for bytes that the checksum learns of later, by count().
  Status appendUncounted(ByteView bytes, std::uint64_t tail_bytes);
  /// The next bytes of the file, in its order, have this checksum.
  void count(std::uint32_t crc, std::uint64_t size_bytes);

  /// Overwrites uncounted bytes.
  Status overwrite(std::uint64_t offset, ByteView bytes);
  /// From `offset` to the end nothing changes any more: the disk may have it.
  Status settle(std::uint64_t offset);
  Status check() { return sink_->check(); }
  Status close() { return sink_->close(); }

 private:
  std::unique_ptr<ByteSink> sink_;
  TailReserve reserve_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
  bool torn_ = false;  ///< half an append stands at the end, and could not be taken back
};

}  // namespace rocinante::mcap
