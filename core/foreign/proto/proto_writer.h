#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante {

/// Appends the fields of one protobuf message (proto3's wire format: tags, varints, little-endian
/// fixed numbers, lengths) to bytes that outlive it. Values that are the type's default are left
/// out, as proto3 has it. Names and texts must be UTF-8.
class ProtoWriter {
 public:
  explicit ProtoWriter(Bytes& out) : out_(out) {}

  /// bool, enum, int32 and int64 of a non-negative value.
  void number(std::uint32_t field, std::uint64_t value);
  /// Of a field with presence: written even when it is zero.
  void index(std::uint32_t field, std::uint64_t value);
  void fixed32(std::uint32_t field, std::uint32_t value);
  void real(std::uint32_t field, double value);
  /// The same for a field with presence (`optional`).
  void presentReal(std::uint32_t field, double value);
  void text(std::uint32_t field, std::string_view value);
  void bytes(std::uint32_t field, ByteView value);
  /// A text in a repeated field: written even when it is empty.
  void element(std::uint32_t field, std::string_view value);

  /// A message in the message, written by `fill(ProtoWriter&)`.
  template <class Fill>
  void message(std::uint32_t field, const Fill& fill) {
    const std::size_t start = begin(field);
    fill(*this);
    end(start);
  }

 private:
  std::size_t begin(std::uint32_t field);
  void end(std::size_t start);
  void tag(std::uint32_t field, std::uint32_t wire_type);
  void varint(std::uint64_t value);

  Bytes& out_;
};

}  // namespace rocinante
