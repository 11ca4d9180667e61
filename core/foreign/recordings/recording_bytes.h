#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/log/mapped_file.h"

namespace rocinante {

/// The bytes of a file, or of memory that outlives this, copied piece by piece: a file may become
/// shorter while it is read.
class RecordingBytes {
 public:
  explicit RecordingBytes(MappedFile file);
  explicit RecordingBytes(ByteView memory) : memory_(memory), size_(memory.size()) {}

  std::size_t size() const { return size_; }
  /// False when not all of them are there.
  bool read(std::size_t from, std::span<std::byte> out) const;

 private:
  MappedFile file_;
  bool is_file_ = false;
  ByteView memory_;
  std::size_t size_ = 0;
};

/// The lines of a text, without LF or CR LF and without a byte order mark. Memory does not grow
/// with the text.
class RecordingLines {
 public:
  /// Longest line; what is longer is skipped.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  explicit RecordingLines(RecordingBytes bytes) : bytes_(std::move(bytes)) {}

  /// The next line, borrowed until the next call. Empty at the end, or where the file has become
  /// shorter: isCut() tells.
  std::optional<std::string_view> next();

  /// The first bytes of the text, whatever lines were read: as many as a line may have.
  std::string head() const;
  /// Whether that is all of it.
  bool isHeadWhole() const { return bytes_.size() <= kMaxBytes; }

  /// Of the last line, from 1.
  std::size_t number() const { return number_; }
  /// True when the last line was too long: it is empty then.
  bool wasTooLong() const { return was_too_long_; }
  bool isCut() const { return is_cut_; }
  /// How much was read, 0 to 1.
  double part() const;

 private:
  bool fill();

  RecordingBytes bytes_;
  std::string window_;
  std::size_t at_ = 0;      ///< in the window
  std::size_t begins_ = 0;  ///< of the window in the text, at its end
  std::size_t number_ = 0;
  bool was_too_long_ = false, is_cut_ = false;
};

}  // namespace rocinante
