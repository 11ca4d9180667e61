#include "core/foreign/decode/number_type.h"

#include <algorithm>
#include <array>
#include <bit>

namespace rocinante::decode {
namespace {

struct TypeFacts {
  std::string_view name;
  NumberType type;
  std::size_t bytes;
  bool whole;
  bool with_sign;
};

constexpr std::array<TypeFacts, 13> kTypes{{
    {"u8", NumberType::u8, 1, true, false},
    {"i8", NumberType::i8, 1, true, true},
    {"u16", NumberType::u16, 2, true, false},
    {"i16", NumberType::i16, 2, true, true},
    {"u24", NumberType::u24, 3, true, false},
    {"i24", NumberType::i24, 3, true, true},
    {"u32", NumberType::u32, 4, true, false},
    {"i32", NumberType::i32, 4, true, true},
    {"u64", NumberType::u64, 8, true, false},
    {"i64", NumberType::i64, 8, true, true},
    {"f32", NumberType::f32, 4, false, true},
    {"f64", NumberType::f64, 8, false, true},
    {"text", NumberType::text, 0, false, false},
}};

/// In the order of NumberType.
const TypeFacts& factsOf(NumberType type) { return kTypes[static_cast<std::size_t>(type)]; }

std::uint64_t wholeIn(ByteView bytes, bool little_endian) {
  std::uint64_t whole = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t place = little_endian ? bytes.size() - 1 - i : i;
    whole = (whole << 8U) | static_cast<std::uint64_t>(bytes[place]);
  }
  return whole;
}

double signedNumber(std::uint64_t whole, unsigned bits, bool with_sign) {
  if (!with_sign || ((whole >> (bits - 1U)) & 1U) == 0) return static_cast<double>(whole);
  if (bits < 64) whole |= ~std::uint64_t{0} << bits;
  return static_cast<double>(static_cast<std::int64_t>(whole));
}

}  // namespace

std::optional<NumberType> numberTypeNamed(std::string_view name) {
  const auto found = std::ranges::find(kTypes, name, &TypeFacts::name);
  if (found == kTypes.end()) return std::nullopt;
  return found->type;
}

std::size_t bytesOf(NumberType type) { return factsOf(type).bytes; }
bool isWhole(NumberType type) { return factsOf(type).whole; }
bool isSigned(NumberType type) { return factsOf(type).with_sign; }

double numberIn(const Field& field, ByteView bytes) {
  std::uint64_t whole = wholeIn(bytes, field.little_endian);
  if (field.type == NumberType::f64) return std::bit_cast<double>(whole);
  if (field.type == NumberType::f32) {
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(whole)));
  }
  unsigned bits = static_cast<unsigned>(bytes.size()) * 8;
  if (field.bits > 0) {
    whole >>= field.first_bit;
    bits = field.bits;
    if (bits < 64) whole &= (std::uint64_t{1} << bits) - 1;
  }
  return signedNumber(whole, bits, isSigned(field.type));
}

}  // namespace rocinante::decode
