#include "core/foreign/ros/field_cursor.h"

#include <bit>

namespace rocinante::ros {
namespace {

/// Before every CDR message: 0, the kind, and two bytes of options.
constexpr std::size_t kHeadBytes = 4;

static_assert(std::endian::native == std::endian::little,
              "little-endian numbers are copied as they are in memory");

}  // namespace

FieldCursor::FieldCursor(ByteView message, Layout layout) : bytes_(message), layout_(layout) {
  if (layout == Layout::ros1) return;
  const ByteView head = take(kHeadBytes);
  if (!ok_) return;
  const auto kind = std::to_integer<std::uint8_t>(head[1]);
  origin_ = kHeadBytes;
  // 0 and 1: XCDR version 1. 6 and 7: plain version 2. The odd ones are little-endian.
  const bool first_version = kind <= 1;
  if (head[0] != std::byte{0} || !(first_version || kind == 6 || kind == 7)) {
    ok_ = false;
    return;
  }
  largest_alignment_ = first_version ? 8 : 4;
  swapped_ = kind % 2 == 0;
}

std::string_view FieldCursor::string() {
  const auto bytes = number<std::uint32_t>();
  std::string_view text = textOf(take(bytes));
  if (layout_ == Layout::cdr && !text.empty() && text.back() == '\0') text.remove_suffix(1);
  return text;
}

std::uint32_t FieldCursor::count(std::size_t least_bytes) {
  const auto count = number<std::uint32_t>();
  if (!ok_ || count > remaining() / least_bytes) {
    ok_ = false;
    return 0;
  }
  return count;
}

void FieldCursor::numbers(std::vector<double>& out) {
  const std::uint32_t many = count(sizeof(double));
  out.resize(many);
  if (many == 0) return;
  align(sizeof(double));
  const ByteView bytes = take(std::uint64_t{many} * sizeof(double));
  if (!ok_) {
    out.clear();
  } else if (!swapped_) {
    std::memcpy(out.data(), bytes.data(), bytes.size());
  } else {
    for (std::size_t i = 0; i < many; ++i) {
      out[i] = load<double>(bytes.data() + i * sizeof(double));
    }
  }
}

void FieldCursor::skip(std::uint64_t count, std::size_t bytes) {
  if (count == 0) return;
  align(bytes);
  if (count > remaining() / bytes) {
    ok_ = false;
    return;
  }
  position_ += static_cast<std::size_t>(count) * bytes;
}

void FieldCursor::moveTo(std::size_t position) {
  if (!ok_ || position < position_ || position > bytes_.size()) {
    ok_ = false;
    return;
  }
  position_ = position;
}

}  // namespace rocinante::ros
