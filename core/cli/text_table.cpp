#include "core/cli/text_table.h"

#include <algorithm>

namespace rocinante::cli {
namespace {

constexpr std::string_view kDots = "...";

bool beginsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }

std::size_t placesOf(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, beginsCharacter));
}

/// Texts are cut to no less than this; before they are cut to less than kReadable, columns go.
constexpr std::size_t kLeast = 12, kReadable = 16;

struct Layout {
  std::vector<std::size_t> widths;
  std::vector<bool> is_left_out;
};

Layout layoutFor(const TextTable& table, std::vector<std::size_t> widths, std::size_t columns) {
  Layout layout{std::move(widths), std::vector<bool>(table.is_number.size(), false)};
  if (columns == 0) return layout;
  const auto mayBeCut = [&](std::size_t i) {
    return !table.is_number[i] && !layout.is_left_out[i] &&
           std::ranges::find(table.whole, i) == table.whole.end();
  };
  const auto total = [&](std::size_t most_of_text) {
    std::size_t places = 0;
    for (std::size_t i = 0; i < layout.widths.size(); ++i) {
      if (layout.is_left_out[i]) continue;
      places += 2 + (mayBeCut(i) ? std::min(layout.widths[i], most_of_text) : layout.widths[i]);
    }
    return places;
  };
  for (const std::size_t column : table.expendable) {
    if (total(kReadable) <= columns) break;
    layout.is_left_out[column] = true;
  }
  std::size_t most = 0;
  for (const std::size_t width : layout.widths) most = std::max(most, width);
  while (most > kLeast && total(most) > columns) --most;
  // The last step cut all of the widest by one: those that may, keep it.
  std::size_t spare = columns - std::min(columns, total(most));
  for (std::size_t i = 0; i < layout.widths.size(); ++i) {
    if (!mayBeCut(i) || layout.widths[i] <= most) continue;
    layout.widths[i] = most + (spare > 0 ? 1 : 0);
    if (spare > 0) --spare;
  }
  return layout;
}

}  // namespace

std::string_view firstPlaces(std::string_view line, std::size_t places) {
  std::size_t end = 0;
  for (std::size_t seen = 0; end < line.size(); ++end) {
    if (beginsCharacter(line[end]) && seen++ == places) break;
  }
  return line.substr(0, end);
}

std::string withoutMiddle(std::string_view text, std::size_t places) {
  const std::size_t all = placesOf(text);
  if (places == 0 || all <= places) return std::string(text);
  if (places <= kDots.size()) return std::string(firstPlaces(text, places));
  const std::size_t kept = places - kDots.size();
  const std::size_t begin = firstPlaces(text, all - kept / 2).size();
  return std::string(firstPlaces(text, kept - kept / 2)) + std::string(kDots) +
         std::string(text.substr(begin));
}

std::string withoutEnd(std::string_view text, std::size_t places) {
  if (places == 0 || placesOf(text) <= places) return std::string(text);
  if (places <= kDots.size()) return std::string(firstPlaces(text, places));
  return std::string(firstPlaces(text, places - kDots.size())) + std::string(kDots);
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent) {
  // Where so little room is left, lines of single words would be no help.
  if (columns < indent + 20) return std::string(text);
  std::string out;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n')) {
    out += wrapped(text.substr(0, end), columns, indent) + '\n';
    text.remove_prefix(end + 1);
  }
  for (std::size_t room = columns;; room = columns - indent) {
    if (placesOf(text) <= room) return out.append(text);
    // A space may lie right behind the last place.
    std::size_t end = text.substr(0, firstPlaces(text, room + 1).size()).rfind(' ');
    if (end == text.npos || text.find_first_not_of(' ') > end) {
      end = text.find(' ', text.find_first_not_of(' '));
    }
    const std::size_t next = end == text.npos ? text.npos : text.find_first_not_of(' ', end);
    if (next == text.npos) return out.append(text);
    out.append(text.substr(0, text.find_last_not_of(' ', end) + 1));
    out += '\n' + std::string(indent, ' ');
    text.remove_prefix(next);
  }
}

std::string TextTable::text(std::size_t columns) const {
  std::vector<std::size_t> widths(is_number.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], placesOf(row[i]));
  }
  const Layout layout = layoutFor(*this, std::move(widths), columns);
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (layout.is_left_out[i]) continue;
      const bool is_last = i + 1 == row.size();
      const std::string cell =
          is_last ? withoutEnd(row[i], layout.widths[i]) : withoutMiddle(row[i], layout.widths[i]);
      const std::string padding(layout.widths[i] - placesOf(cell), ' ');
      line += "  ";
      if (is_number[i]) line += padding;
      line += cell;
      if (!is_number[i] && !is_last) line += padding;
    }
    if (columns > 0) line = firstPlaces(line, columns);
    while (line.ends_with(' ')) line.pop_back();
    out += line + "\n";
  }
  std::string names;
  for (const std::size_t column : expendable) {
    if (layout.is_left_out[column]) names += (names.empty() ? "" : ", ") + rows.front()[column];
  }
  if (names.empty()) return out;
  return out + wrapped("  (a wider terminal shows more: " + names + ")", columns, 4) + "\n";
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
