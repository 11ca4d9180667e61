#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

/// Reads the decimal number at `at`, exactly (the nearest double, ties to even) in any locale. On
/// success `at` is after it. False for anything but a finite decimal: nan, inf, hex, overflow. A
/// sign, digits, a point with or without digits on one side, an exponent; -0 reads as 0, and so
/// does a value too small for a double.
bool readNumber(const char*& at, const char* end, double& number);

/// Whether a text spells a number that a packet cannot have: nan, inf or infinity, with a sign or
/// without, in any case.
bool isNotFiniteWord(std::string_view text);

/// Reads decimal digits alone, at least one; empty when the number exceeds 64 bits.
std::optional<std::uint64_t> readUnsigned(std::string_view digits);

/// "12.5": seconds with up to nine decimals as nanoseconds; no sign, no exponent.
std::optional<std::int64_t> readSeconds(std::string_view text);

/// Reads exactly `digits` hexadecimal digits.
std::optional<std::uint64_t> readHex(std::string_view text, std::size_t digits);

/// Appends the shortest decimal that reads back as the same double; -0 as 0.
void appendNumber(std::string& text, double number);
void appendUnsigned(std::string& text, std::uint64_t number);
void appendSeconds(std::string& text, std::int64_t nanoseconds);
/// Appends exactly `digits` lower-case hexadecimal digits.
void appendHex(std::string& text, std::uint64_t number, int digits);

}  // namespace rocinante
