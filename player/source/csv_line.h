#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// One field of a line of comma-separated values, without spaces around it and without the quotes
/// that enclose it (RFC 4180).
struct CsvField {
  std::string_view text;   ///< between the quotes, a doubled quote still doubled
  std::size_t column = 1;  ///< of the field's first byte in its line, from 1
  bool has_inner_quotes = false;

  /// With doubled quotes undone.
  std::string unescaped() const;
};

/// Splits one line, which holds no line end. False when a quote is left open or something stands
/// behind a closing one; `fields` then ends with the field that is wrong.
bool splitCsvLine(std::string_view line, std::vector<CsvField>& fields);

/// Takes the next line off `text`, without its LF or CR LF. Empty at the end.
std::optional<std::string_view> takeLine(std::string_view& text);

}  // namespace rocinante
