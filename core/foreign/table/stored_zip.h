#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// Writes a ZIP file (APPNOTE 6.3, with ZIP64) whose entries are stored as they are. The sink must
/// be new and overwritable; the caller closes it.
class StoredZip {
 public:
  explicit StoredZip(ByteSink& out) : out_(out) {}

  /// Then append() of exactly `size` bytes. `name` is UTF-8, at most 65,535 bytes.
  Status beginEntry(std::string name, std::uint64_t size);
  Status append(ByteView bytes);
  Status endEntry();
  /// The directory. No call may follow.
  Status end();

 private:
  struct Entry {
    std::string name;
    std::uint64_t size = 0;
    std::uint64_t offset = 0;  ///< of its local header
    std::uint32_t crc = 0;
  };

  Status put(ByteView bytes);

  ByteSink& out_;
  std::vector<Entry> entries_;
  std::uint64_t written_ = 0;
};

}  // namespace rocinante
