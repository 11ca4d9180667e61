#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante::cli {

/// Rows of cells as lines, every column as wide as its widest cell; the last column is not padded.
/// Cells are UTF-8, one column per character.
struct TextTable {
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> is_number;  ///< by column: set to the right; one for each cell of a row

  /// Lines begin with two spaces and are cut after `columns` characters; 0: never.
  std::string text(std::size_t columns = 0) const;
};

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);

/// "1 message", "2,000 messages".
std::string counted(std::uint64_t number, std::string_view one);

/// The first `places` characters of a line of UTF-8.
std::string_view firstPlaces(std::string_view line, std::size_t places);

}  // namespace rocinante::cli
