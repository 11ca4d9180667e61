#include "core/foreign/proto/proto_writer.h"

#include <bit>

#include "core/foreign/bytes/little_endian.h"

namespace rocinante {
namespace {

enum WireType : std::uint32_t { kVarint = 0, kFixed64 = 1, kLength = 2, kFixed32 = 5 };

}  // namespace

void ProtoWriter::varint(std::uint64_t value) {
  while (value >= 0x80) {
    out_.push_back(static_cast<std::byte>(value | 0x80));
    value >>= 7U;
  }
  out_.push_back(static_cast<std::byte>(value));
}

void ProtoWriter::tag(std::uint32_t field, std::uint32_t wire_type) {
  varint(std::uint64_t{field} << 3U | wire_type);
}

void ProtoWriter::number(std::uint32_t field, std::uint64_t value) {
  if (value != 0) index(field, value);
}

void ProtoWriter::index(std::uint32_t field, std::uint64_t value) {
  tag(field, kVarint);
  varint(value);
}

void ProtoWriter::fixed32(std::uint32_t field, std::uint32_t value) {
  if (value == 0) return;
  tag(field, kFixed32);
  appendLittle(out_, value);
}

void ProtoWriter::real(std::uint32_t field, double value) {
  // The bits decide: -0 is not the default.
  if (std::bit_cast<std::uint64_t>(value) != 0) presentReal(field, value);
}

void ProtoWriter::presentReal(std::uint32_t field, double value) {
  tag(field, kFixed64);
  appendLittle(out_, value);
}

void ProtoWriter::text(std::uint32_t field, std::string_view value) {
  if (!value.empty()) element(field, value);
}

void ProtoWriter::bytes(std::uint32_t field, ByteView value) { text(field, textOf(value)); }

void ProtoWriter::element(std::uint32_t field, std::string_view value) {
  tag(field, kLength);
  varint(value.size());
  appendBytes(out_, bytesOf(value));
}

std::size_t ProtoWriter::begin(std::uint32_t field) {
  tag(field, kLength);
  // One byte for the length: most messages are short, and end() makes room for the others.
  out_.push_back(std::byte{0});
  return out_.size();
}

void ProtoWriter::end(std::size_t start) {
  std::uint64_t length = out_.size() - start;
  std::byte digits[10];
  std::size_t count = 0;
  for (; length >= 0x80; length >>= 7U) digits[count++] = static_cast<std::byte>(length | 0x80);
  digits[count++] = static_cast<std::byte>(length);
  out_[start - 1] = digits[0];
  out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(start), digits + 1, digits + count);
}

}  // namespace rocinante
