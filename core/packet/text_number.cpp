#include "core/packet/text_number.h"

#include <fast_float/fast_float.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/hex_digit.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

bool isSeparator(char character) { return character == ' ' || character == '\t'; }

// Powers of ten that a double holds exactly: dividing an integer below 2^53 by one rounds once.
constexpr std::array<double, 23> kExactPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

constexpr std::array<std::uint64_t, 9> kPowers = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

// Several digits at once, because a loop would wait for each. The bytes of digits become 0 to 9;
// other bytes get their highest bit set (a carry only reaches the bytes behind them).
static_assert(std::endian::native == std::endian::little);

template <class Unsigned>
Unsigned loadDigits(const char* at) {
  Unsigned bytes;
  std::memcpy(&bytes, at, sizeof bytes);
  return bytes ^ static_cast<Unsigned>(0x3030303030303030U);
}

template <class Unsigned>
Unsigned otherBytes(Unsigned bytes) {
  return ((bytes + static_cast<Unsigned>(0x7676767676767676U)) | bytes) &
         static_cast<Unsigned>(0x8080808080808080U);
}

std::uint64_t valueOf(std::uint64_t eight) {
  eight = eight * 10 + (eight >> 8U);
  return (((eight & 0x000000FF000000FFU) * 0x000F424000000064U) +
          (((eight >> 16U) & 0x000000FF000000FFU) * 0x0000271000000001U)) >>
         32U;
}

std::uint64_t valueOf(std::uint32_t four) {
  four = four * 10 + (four >> 8U);
  return ((four & 0x00FF00FFU) * 0x00640001U) >> 16U;
}

/// Reads the digits from `at` on and moves `at` behind them; digits that do not fit are dropped.
void readDigits(const char*& at, const char* end, std::uint64_t& number) {
  if (end - at >= 8) {
    const std::uint64_t bytes = loadDigits<std::uint64_t>(at);
    const std::uint64_t others = otherBytes(bytes);
    const std::size_t count =
        others == 0 ? 8 : static_cast<std::size_t>(std::countr_zero(others)) / 8;
    if (count > 0) number = number * kPowers[count] + valueOf(bytes << 8 * (8 - count));
    at += count;
    if (count < 8) return;
  }
  for (; at != end && isDigit(*at); ++at) {
    number = number * 10 + static_cast<std::uint64_t>(*at - '0');
  }
}

bool readAnyNumber(const char* first, const char* end, const char*& at, double& number) {
  const char* field_end = first;
  while (field_end != end && !isSeparator(*field_end)) ++field_end;
  const auto answer = fast_float::from_chars(first, field_end, number);
  if (answer.ptr != field_end || !std::isfinite(number)) return false;
  if (answer.ec != std::errc() && answer.ec != std::errc::result_out_of_range) return false;
  at = field_end;
  return true;
}

}  // namespace

bool readNumber(const char*& at, const char* end, double& number) {
  if (at == end) return false;
  // Without a branch: the sign of a joint is unpredictable.
  const bool negative = *at == '-';
  const char* next = at + static_cast<int>(negative | (*at == '+'));
  const char* const first = next;
  std::uint64_t mantissa = 0;
  for (; next != end && isDigit(*next); ++next) {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*next - '0');
  }
  std::size_t digits = static_cast<std::size_t>(next - first);
  std::size_t decimals = 0;
  if (next != end && *next == '.') {
    const char* const point = ++next;
    readDigits(next, end, mantissa);
    decimals = static_cast<std::size_t>(next - point);
    digits += decimals;
  }
  if (digits == 0) return false;

  const bool at_end = next == end || isSeparator(*next);
  // Nineteen digits cannot overflow the mantissa, and leave at most 19 decimals.
  if (at_end && digits <= 19 && mantissa <= (std::uint64_t{1} << 53U)) {
    number = static_cast<double>(mantissa) / kExactPowers[decimals];
    at = next;
  } else if (!readAnyNumber(first, end, at, number)) {
    return false;
  }
  constexpr std::array<double, 2> kSigns = {1, -1};
  number = number * kSigns[negative] + 0.0;  // -0 to 0
  return true;
}

bool isNotFiniteWord(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  std::string word(text.substr(0, 9));
  for (char& byte : word) byte = byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte + 32) : byte;
  return word == "nan" || word == "inf" || word == "infinity";
}

std::optional<std::uint64_t> readUnsigned(std::string_view digits) {
  // Nineteen digits cannot overflow.
  if (digits.empty()) return std::nullopt;
  std::uint64_t number = 0;
  if (digits.size() <= 19) {
    const char* at = digits.data();
    const char* const last = at + digits.size();
    for (; last - at >= 8; at += 8) {
      const std::uint64_t eight = loadDigits<std::uint64_t>(at);
      if (otherBytes(eight) != 0) return std::nullopt;
      number = number * kPowers[8] + valueOf(eight);
    }
    if (last - at >= 4) {
      const std::uint32_t four = loadDigits<std::uint32_t>(at);
      if (otherBytes(four) != 0) return std::nullopt;
      number = number * kPowers[4] + valueOf(four);
      at += 4;
    }
    for (; at != last; ++at) {
      if (!isDigit(*at)) return std::nullopt;
      number = number * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    return number;
  }
  const char* const end = digits.data() + digits.size();
  const auto answer = std::from_chars(digits.data(), end, number);
  if (answer.ec != std::errc() || answer.ptr != end) return std::nullopt;
  return number;
}

std::optional<std::int64_t> readSeconds(std::string_view text) {
  constexpr std::uint64_t kNanoseconds = 1'000'000'000;
  const std::size_t point = text.find('.');
  const auto seconds = readUnsigned(text.substr(0, point));
  std::uint64_t fraction = 0;
  if (point != std::string_view::npos) {
    const std::string_view decimals = text.substr(point + 1);
    const auto digits = readUnsigned(decimals);
    if (!digits || decimals.size() > 9) return std::nullopt;
    fraction = *digits * kPowers[9 - decimals.size()];
  }
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (!seconds || *seconds > (kMax - fraction) / kNanoseconds) return std::nullopt;
  return static_cast<std::int64_t>(*seconds * kNanoseconds + fraction);
}

std::optional<std::uint64_t> readHex(std::string_view text, std::size_t digits) {
  if (text.size() != digits) return std::nullopt;
  std::uint64_t number = 0;
  for (const char character : text) {
    const int digit = hexDigit(character);
    if (digit < 0) return std::nullopt;
    number = number * 16 + static_cast<std::uint64_t>(digit);
  }
  return number;
}

void appendNumber(std::string& text, double number) {
  if (number == 0) number = 0;
  std::array<char, 32> digits;
  const auto answer = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), answer.ptr);
}

void appendUnsigned(std::string& text, std::uint64_t number) {
  std::array<char, 20> digits;
  const auto answer = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), answer.ptr);
}

void appendSeconds(std::string& text, std::int64_t nanoseconds) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  appendUnsigned(text, static_cast<std::uint64_t>(nanoseconds / kNanoseconds));
  std::int64_t fraction = nanoseconds % kNanoseconds;
  if (fraction == 0) return;
  text += '.';
  for (std::int64_t place = kNanoseconds / 10; fraction != 0; place /= 10) {
    text += static_cast<char>('0' + fraction / place);
    fraction %= place;
  }
}

void appendHex(std::string& text, std::uint64_t number, int digits) {
  for (int shift = (digits - 1) * 4; shift >= 0; shift -= 4) {
    text += "0123456789abcdef"[(number >> static_cast<unsigned>(shift)) & 15U];
  }
}

}  // namespace rocinante
