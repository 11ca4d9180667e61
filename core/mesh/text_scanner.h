#pragma once

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/base/plain_text.h"

namespace rocinante {

/// Walks through the text of an OBJ, MTL or ASCII STL file line by line. Lines end with LF, CR LF
/// or CR; a backslash before the line's end continues it. Numbers are decimal, read exactly and
/// independently of locale. Never reads past the end; allocates only for names that continue over a
/// line end.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
  }

  bool atEnd() const { return at_ == end_; }
  int line() const { return line_; }  ///< from 1

  /// Skips spaces, tabs and continued line ends; true while the line has more.
  bool skipBlanks() {
    while (at_ != end_) {
      if (*at_ == ' ' || *at_ == '\t') {
        ++at_;
      } else if (*at_ != '\\' || !skipContinuation()) {
        return *at_ != '\n' && *at_ != '\r';
      }
    }
    return false;
  }

  /// Goes to the start of the next line.
  void skipLine() {
    while (at_ != end_) {
      const char c = *at_;
      if (c == '\\' && skipContinuation()) continue;
      if (c == '\n' || c == '\r') return skipLineEnd();
      ++at_;
    }
  }

  /// The word here, up to the next blank or the line's end.
  std::string_view word() {
    const char* from = at_;
    while (at_ != end_ && !isBlankOrEnd(*at_) && !(*at_ == '\\' && continues())) ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

  /// The rest of the line without blanks around it; a continued line end becomes a space.
  std::string restOfLine() {
    skipBlanks();
    std::string rest;
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') {
      if (*at_ == '\\' && skipContinuation()) {
        rest += ' ';
      } else {
        rest += *at_++;
      }
    }
    while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.pop_back();
    return rest;
  }

  /// A finite decimal number followed by a blank or the line's end; else false, with the scanner
  /// where it was. Skips blanks before it.
  bool number(double& value) {
    if (!skipBlanks()) return false;
    const char* from = at_;
    // In registers: `at_` would be stored at every step.
    const char* at = at_;
    const bool negative = *at == '-';
    if (negative || *at == '+') ++at;
    // Up to 2^53 over a power of ten up to 10^22 is one exact division: the common case.
    const char* digits_from = at;
    std::uint64_t mantissa = 0;
    while (at != end_ && isDigit(*at)) mantissa = mantissa * 10 + digitOf(*at++);
    long digits = at - digits_from;
    long decimals = 0;
    if (at != end_ && *at == '.') {
      const char* decimals_from = ++at;
      while (at != end_ && isDigit(*at)) mantissa = mantissa * 10 + digitOf(*at++);
      decimals = at - decimals_from;
      digits += decimals;
    }
    if (digits == 0) return back(from);
    at_ = at;
    const bool ends = at_ == end_ || isBlankOrEnd(*at_) || (*at_ == '\\' && continues());
    if (ends && digits <= 19 && mantissa <= (std::uint64_t{1} << 53U)) {
      value = static_cast<double>(mantissa) / kPowersOfTen[decimals];
      if (negative) value = -value;
      return true;
    }
    double magnitude = 0;
    const auto parsed = fast_float::from_chars(digits_from, end_, magnitude);
    if (parsed.ec != std::errc() || !std::isfinite(magnitude)) return back(from);
    at_ = parsed.ptr;
    if (at_ != end_ && !isBlankOrEnd(*at_) && !(*at_ == '\\' && continues())) return back(from);
    value = negative ? -magnitude : magnitude;
    return true;
  }

  /// A decimal integer, clamped to the range of the type; no valid index has that value. False when
  /// there is no integer here. Blanks are not skipped.
  bool integer(std::int64_t& value) {
    const char* at = at_;
    const bool negative = at != end_ && *at == '-';
    if (negative || (at != end_ && *at == '+')) ++at;
    const char* digits_from = at;
    std::uint64_t magnitude = 0;
    while (at != end_ && isDigit(*at)) magnitude = magnitude * 10 + digitOf(*at++);
    if (at == digits_from) return false;
    // Without leading zeros, this many digits always fit.
    constexpr std::ptrdiff_t kFitting = std::numeric_limits<std::int64_t>::digits10;
    if (at - digits_from > kFitting) magnitude = saturated(digits_from, at);
    at_ = at;
    value = static_cast<std::int64_t>(magnitude);
    if (negative) value = -value;
    return true;
  }

  /// Skips the next character if it is `c`; true then.
  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// True where a word has ended: at a blank, the line's end or the text's.
  bool wordEnds() const {
    return at_ == end_ || isBlankOrEnd(*at_) || (*at_ == '\\' && continues());
  }

 private:
  static constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                            1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
                                            1e14, 1e15, 1e16, 1e17, 1e18, 1e19};

  /// Digits to a number, clamped to the largest that fits.
  static std::uint64_t saturated(const char* from, const char* end) {
    constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    std::uint64_t value = 0;
    for (; from != end; ++from) {
      const std::uint64_t digit = digitOf(*from);
      if (value > (kLargest - digit) / 10) return kLargest;
      value = value * 10 + digit;
    }
    return value;
  }

  static std::uint64_t digitOf(char c) { return static_cast<std::uint64_t>(c - '0'); }
  static bool isBlankOrEnd(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  bool continues() const {
    return end_ - at_ >= 2 && (at_[1] == '\n' || (at_[1] == '\r' && end_ - at_ >= 3));
  }
  bool skipContinuation() {
    if (!continues()) return false;
    ++at_;
    skipLineEnd();
    return true;
  }
  void skipLineEnd() {
    if (*at_ == '\r' && end_ - at_ >= 2 && at_[1] == '\n') ++at_;
    ++at_;
    ++line_;
  }
  bool back(const char* to) {
    at_ = to;
    return false;
  }

  const char* at_;
  const char* end_;
  int line_ = 1;
};

}  // namespace rocinante
