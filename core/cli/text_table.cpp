#include "core/cli/text_table.h"

#include <algorithm>

namespace rocinante::cli {
namespace {

bool beginsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }

std::size_t placesOf(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, beginsCharacter));
}

}  // namespace

std::string_view firstPlaces(std::string_view line, std::size_t places) {
  std::size_t end = 0;
  for (std::size_t seen = 0; end < line.size(); ++end) {
    if (beginsCharacter(line[end]) && seen++ == places) break;
  }
  return line.substr(0, end);
}

std::string TextTable::text(std::size_t columns) const {
  std::vector<std::size_t> widths(is_number.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], placesOf(row[i]));
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - placesOf(row[i]), ' ');
      line += "  ";
      if (is_number[i]) line += padding;
      line += row[i];
      if (!is_number[i] && i + 1 < row.size()) line += padding;
    }
    if (columns > 0) line = firstPlaces(line, columns);
    while (line.ends_with(' ')) line.pop_back();
    out += line + "\n";
  }
  return out;
}

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

std::string counted(std::uint64_t number, std::string_view one) {
  std::string text = grouped(number) + " " + std::string(one);
  return number == 1 ? text : text + "s";
}

}  // namespace rocinante::cli
