#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/bytes.h"

namespace rocinante::ros {

/// Reads the fields of a ROS message one after another from borrowed bytes: CDR of ROS 2 (XCDR
/// version 1 and plain version 2, either byte order) or the serialization of ROS 1. Never reads
/// past their end, and takes no length at its word: a read that does not fit fails, and so do all
/// reads after it, so that a whole message can be read before one call of ok(). Allocates only for
/// numbers(), after their count was checked.
class FieldCursor {
 public:
  enum class Layout : std::uint8_t { cdr, ros1 };

  /// Fails at once when the bytes do not begin with a CDR head of a known kind.
  FieldCursor(ByteView message, Layout layout);

  bool ok() const { return ok_; }
  bool isRos1() const { return layout_ == Layout::ros1; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  /// True when everything was read, but for the padding that some writers add.
  bool atEnd() const { return ok_ && remaining() < 4; }

  template <class T>
  requires std::is_arithmetic_v<T> T number() {
    align(sizeof(T));
    const ByteView bytes = take(sizeof(T));
    T value{};
    if (ok_) value = load<T>(bytes.data());
    return value;
  }
  bool boolean() { return number<std::uint8_t>() != 0; }

  /// Without the zero that ends it. Borrowed.
  std::string_view string();
  /// The count before a sequence, when as many elements of at least `least_bytes` each fit into
  /// what remains; otherwise the cursor fails.
  std::uint32_t count(std::size_t least_bytes);
  /// A sequence of doubles.
  void numbers(std::vector<double>& out);
  /// Steps over `count` elements of `bytes` each.
  void skip(std::uint64_t count, std::size_t bytes);
  /// Steps to `position`, which is not before the present one.
  void moveTo(std::size_t position);
  void fail() { ok_ = false; }
  /// The bytes between two positions.
  ByteView between(std::size_t from, std::size_t to) const {
    return bytes_.subspan(from, to - from);
  }

 private:
  void align(std::size_t size) {
    const std::size_t bound = size < largest_alignment_ ? size : largest_alignment_;
    position_ += (0 - (position_ - origin_)) & (bound - 1);
    if (position_ > bytes_.size()) {
      position_ = bytes_.size();
      ok_ = false;
    }
  }

  ByteView take(std::uint64_t count) {
    if (!ok_ || count > remaining()) {
      ok_ = false;
      return {};
    }
    const ByteView taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
  }

  template <class T>
  T load(const std::byte* from) const {
    T value;
    if (!swapped_) {
      std::memcpy(&value, from, sizeof(T));
      return value;
    }
    std::byte reversed[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) reversed[i] = from[sizeof(T) - 1 - i];
    std::memcpy(&value, reversed, sizeof(T));
    return value;
  }

  ByteView bytes_;
  std::size_t position_ = 0;
  std::size_t origin_ = 0;             ///< alignment is counted from here
  std::size_t largest_alignment_ = 1;  ///< a power of two
  Layout layout_;
  bool swapped_ = false;
  bool ok_ = true;
};

}  // namespace rocinante::ros
