#include "core/math/angle_reduction.h"

#include <array>
#include <bit>
#include <cstdint>

namespace rocinante {
namespace {

__extension__ using Wide = unsigned __int128;

// 2/pi in binary, after 64 zeros in place of the digits before its point: reading for an angle
// below 2^63 begins there. 1152 digits reach the last one that the largest double needs.
constexpr std::array<std::uint64_t, 20> kTwoOverPi = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
    0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
    0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

// pi/2 * 2^127
constexpr std::uint64_t kHalfPiHigh = 0xc90fdaa22168c234;
constexpr std::uint64_t kHalfPiLow = 0xc4c6628b80dc1cd1;

constexpr double kQuarterPi = 0x1.921fb54442d18p-1;
constexpr std::uint64_t kMantissaMask = (std::uint64_t{1} << 52) - 1;

std::uint64_t highOf(Wide wide) { return static_cast<std::uint64_t>(wide >> 64); }
std::uint64_t lowOf(Wide wide) { return static_cast<std::uint64_t>(wide); }

// 64 digits of 2/pi from digit `position` of the table.
std::uint64_t digitsAt(unsigned position) {
  const unsigned word = position / 64, shift = position % 64;
  if (shift == 0) return kTwoOverPi[word];
  return kTwoOverPi[word] << shift | kTwoOverPi[word + 1] >> (64 - shift);
}

// 2^exponent for exponents of normal doubles.
double powerOfTwo(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// The upper 128 bits of the product of two 128-bit numbers, low by at most 3 units of the last
// place.
Wide highProduct(Wide a, std::uint64_t b_high, std::uint64_t b_low) {
  const Wide upper = Wide{highOf(a)} * b_high;
  const Wide middle_a = Wide{highOf(a)} * b_low;
  const Wide middle_b = Wide{lowOf(a)} * b_high;
  return upper + highOf(middle_a) + highOf(middle_b);
}

}  // namespace

ReducedAngle reduceAngle(double angle_rad) {
  if (angle_rad <= kQuarterPi) return {angle_rad, 0.0, 0};

  // angle = mantissa * 2^exponent, and digits of 2/pi that only add multiples of 4 right angles
  // are skipped: the product below is (angle * 2/pi mod 4) * 2^190.
  const auto bits = std::bit_cast<std::uint64_t>(angle_rad);
  const std::uint64_t mantissa = (bits & kMantissaMask) | (kMantissaMask + 1);
  const int exponent = static_cast<int>(bits >> 52) - 1075;
  const auto position = static_cast<unsigned>(exponent + 62);

  const Wide product_low = Wide{mantissa} * digitsAt(position + 128);
  const Wide product_middle = Wide{mantissa} * digitsAt(position + 64) + highOf(product_low);
  const std::uint64_t top = mantissa * digitsAt(position) + highOf(product_middle);
  Wide fraction = Wide{lowOf(product_middle)} << 64 | lowOf(product_low);

  // Two digits of quadrant, then 190 of fraction, moved to fill 128 with the rest behind.
  unsigned quadrant = static_cast<unsigned>(top >> 62);
  std::uint64_t head = top << 2 | highOf(fraction) >> 62;
  fraction <<= 2;
  const bool nearer_to_next = head >> 63 != 0;
  if (nearer_to_next) {
    ++quadrant;
    fraction = ~fraction + 1;
    head = ~head + (fraction == 0 ? 1 : 0);
  }
  int leading = std::countl_zero(head);
  Wide digits = Wide{head} << 64 | highOf(fraction);
  if (leading < 64) {
    if (leading > 0) digits = digits << leading | lowOf(fraction) >> (64 - leading);
  } else {
    leading = 64 + std::countl_zero(highOf(fraction));
    digits = fraction << (leading - 64);
  }

  const Wide product = highProduct(digits, kHalfPiHigh, kHalfPiLow);  // * 2^-(127 + leading)
  const int scale = -127 - leading;
  const auto high = static_cast<std::uint64_t>(product >> 75);
  const auto low = static_cast<std::uint64_t>(product >> 22) & (2 * kMantissaMask + 1);
  const double sign = nearer_to_next ? -1.0 : 1.0;
  return {sign * static_cast<double>(high) * powerOfTwo(scale + 75),
          sign * static_cast<double>(low) * powerOfTwo(scale + 22), quadrant & 3};
}

}  // namespace rocinante
