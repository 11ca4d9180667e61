#include "core/foreign/recordings/text_refusal.h"

#include <algorithm>

#include "core/foreign/recordings/json_lines.h"
#include "core/foreign/recordings/table_recording.h"

namespace rocinante {
namespace {

bool isRead(std::string_view text) { return looksLikeTable(text) || looksLikeJsonLines(text); }

std::string with(std::string text, char old, char now) {
  std::ranges::replace(text, old, now);
  return text;
}

bool isJsonArray(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t array = text.find_first_not_of(kBlanks);
  if (array == text.npos || text[array] != '[') return false;
  const std::size_t object = text.find_first_not_of(kBlanks, array + 1);
  return object != text.npos && text[object] == '{';
}

}  // namespace

std::optional<std::string> textRefusal(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return "it is text in UTF-16, and UTF-8 is read: `iconv -f UTF-16 -t UTF-8 FILE` converts it";
  }
  if (isJsonArray(text)) {
    return "it is one array of JSON, and JSON lines are read, an object a line: `jq -c '.[]' FILE` "
           "makes them";
  }
  if (text.find('\n') == text.npos && isRead(with(std::string(text), '\r', '\n')) &&
      text.find('\r') != text.npos) {
    return "its lines end with CR alone, and LF or CR LF is read: `tr '\\r' '\\n' <FILE` converts "
           "it";
  }
  const std::string_view first = text.substr(0, text.find('\n'));
  if (first.find('|') != first.npos && isRead(with(std::string(text), '|', ';'))) {
    return "its columns are separated by `|`, and commas, semicolons, tabs or blanks are read: `tr "
           "'|' ';' <FILE` converts it";
  }
  return std::nullopt;
}

}  // namespace rocinante
