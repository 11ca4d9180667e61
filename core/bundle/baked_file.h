#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A name for what a baked file was made of.
using BakedKey = std::array<std::byte, 16>;

/// The container of a baked cell (docs/baked-cell.md): magic, format, key, total length, and a
/// table of sections with their lengths and CRC-32. Little-endian; nothing between sections or
/// behind them.
class BakedFile {
 public:
  static constexpr std::uint32_t kFormat = 4;
  static constexpr std::size_t kMaxSections = 64;

  struct Section {
    std::uint32_t id = 0;
    ByteView content;  ///< borrowed
  };

  /// Checks header, table, lengths and every checksum. unsupported for another format; damaged with
  /// the first fault otherwise. `bytes` is borrowed; `name` is used in messages.
  static Result<BakedFile> parse(ByteView bytes, const std::string& name);

  const BakedKey& key() const { return key_; }
  const std::vector<Section>& sections() const { return sections_; }
  /// damaged when there is none.
  Result<ByteView> section(std::uint32_t id) const;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  BakedKey key_{};
  std::vector<Section> sections_;
};

/// The bytes of a file with these sections, at most kMaxSections with different ids.
Bytes bakedFile(const BakedKey& key, const std::vector<BakedFile::Section>& sections);

}  // namespace rocinante
