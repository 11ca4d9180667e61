#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// One field of a CSV line (RFC 4180), without surrounding spaces and quotes.
struct CsvField {
  std::string_view text;   ///< between the quotes; doubled quotes still doubled
  std::size_t column = 1;  ///< of the field's first byte in its line, from 1
  bool has_inner_quotes = false;

  /// The text with doubled quotes made single.
  std::string unescaped() const;
};

/// Splits one line without its line end; the separator ' ' stands for any number of blanks. False
/// when a quote is left open or text follows a closing one; `fields` then ends with the wrong
/// field.
bool splitCsvLine(std::string_view line, std::vector<CsvField>& fields, char separator = ',');

/// Removes the next line from `text`, without its LF or CR LF. Empty at the end.
std::optional<std::string_view> takeLine(std::string_view& text);

}  // namespace rocinante
