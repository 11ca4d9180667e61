#include "viewer/ui/panels/panel_layout.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rocinante {
namespace {

constexpr std::size_t kLongestUnit = 4;

bool isNumber(std::string_view word) {
  constexpr std::string_view kDigits = "0123456789";
  return !word.empty() && kDigits.find(word.back()) != std::string_view::npos &&
         word.find_first_not_of("+-.,0123456789") == std::string_view::npos;
}

/// The words of a line, each with the spaces before it, and a unit with its number.
std::vector<std::string_view> wordsOf(std::string_view line, float room, const TextWidth& width) {
  std::vector<std::string_view> words;
  std::size_t begin = 0, number = std::string_view::npos;
  while (begin < line.size()) {
    const std::size_t first = std::min(line.find_first_not_of(' ', begin), line.size());
    const std::size_t end = std::min(line.find(' ', first), line.size());
    const std::string_view word = line.substr(first, end - first);
    const std::string_view both =
        number == std::string_view::npos ? word : line.substr(number, end - number);
    if (number != std::string_view::npos && word.size() <= kLongestUnit && width(both) <= room) {
      words.back() = line.substr(begin - words.back().size(), words.back().size() + end - begin);
      number = std::string_view::npos;
    } else {
      words.push_back(line.substr(begin, end - begin));
      number = isNumber(word) ? first : std::string_view::npos;
    }
    begin = end;
  }
  return words;
}

}  // namespace

float listHeight(std::size_t rows, float row_height, float room) {
  constexpr float kLeastRows = 3;
  const float wanted = static_cast<float>(rows) * row_height;
  return std::max(std::min(wanted, room), kLeastRows * row_height);
}

std::string inLines(std::string_view text, float room, const TextWidth& width) {
  std::string all;
  while (true) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line;
    for (const std::string_view word : wordsOf(text.substr(0, end), room, width)) {
      std::string longer = line + std::string(word);
      if (line.empty() || width(longer) <= room) {
        line = std::move(longer);
        continue;
      }
      all += line + '\n';
      line = word.substr(std::min(word.find_first_not_of(' '), word.size()));
    }
    all += line;
    if (end == text.size()) return all;
    all += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace rocinante
