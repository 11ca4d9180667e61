#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/foreign/table/table_header.h"
#include "core/packet/session_state.h"

namespace rocinante {

enum class TableValue : std::uint8_t {
  number,
  nothing,  ///< no value yet: empty, or a word for it: "nan", "n/a", "null", "-"
  text
};

/// The numbers of one table. A decimal comma is read where it can be nothing else: in a table that
/// commas do not separate, whose first number with a sign for decimals has a comma.
class TableNumbers {
 public:
  explicit TableNumbers(char separator) : decimal_(separator == ',' ? '.' : '\0') {}

  /// Finite and below 2^53 in magnitude, else it is text.
  TableValue read(std::string_view text, double& number);
  /// A value of a signal: any finite number; `true` and `false`, in any case, or another text.
  /// Empty: no value yet. `text` is with quotes taken off.
  std::optional<SignalValue> readSignal(std::string_view text);
  /// The number as packet text has it; borrowed until the next call.
  std::string_view withPoint(std::string_view text);

 private:
  char decimal_;  ///< '\0': not known yet
  std::string pointed_;
};

/// The times of one table: numbers of seconds or parts of them, or dates ("2023-11-14T22:13:20.5Z";
/// without a zone UTC).
class TableTimes {
 public:
  explicit TableTimes(TimeUnit unit) : unit_(unit) {}

  /// `text` with a decimal point. To the nearest nanosecond; empty when it is no time.
  std::optional<Nanoseconds> read(std::string_view text);

 private:
  TimeUnit unit_;
};

/// Whether a signal can have the text: UTF-8 of at most 4,096 bytes, with no control characters but
/// tabs and line feeds.
bool isSignalText(std::string_view text);
inline constexpr std::string_view kNoSignalText =
    "a text of more than 4,096 bytes, not in UTF-8, or with control characters";

/// A word for "no value": an empty text is one.
bool isNoValue(std::string_view text);

}  // namespace rocinante
