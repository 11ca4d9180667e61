#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante::cli {

/// Rows of cells as lines, every column as wide as its widest cell; the last column is not padded.
/// Cells are UTF-8, one column per character. The first row names the columns.
struct TextTable {
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> is_number;  ///< by column: set to the right; one for each cell of a row
  /// For terminals that are too narrow: columns that are left out, in this order, and then named
  /// below the table; and columns of text that are shown whole or not at all.
  std::vector<std::size_t> expendable{}, whole{};

  /// Lines begin with two spaces and have at most `columns` characters, 0: any number. Where they
  /// would have more, columns are left out, then the widest texts are cut: names in the middle, the
  /// last column at its end.
  std::string text(std::size_t columns = 0) const;
};

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);

/// "1 message", "2,000 messages".
std::string counted(std::uint64_t number, std::string_view one);

/// The first `places` characters of a line of UTF-8.
std::string_view firstPlaces(std::string_view line, std::size_t places);

/// At most `places` characters of `text`, with "..." for what is left out of its middle, or of its
/// end: "forearm_c...ty_link", "joint6 has mo...". 0: all of it.
std::string withoutMiddle(std::string_view text, std::size_t places);
std::string withoutEnd(std::string_view text, std::size_t places);

/// Each line of `text` in lines of at most `columns` characters, 0: any number. It is broken at
/// spaces, and goes on behind `indent` spaces. Words that are longer than a line stay whole.
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent);

}  // namespace rocinante::cli
