#include "core/foreign/table/csv_line.h"

namespace rocinante {
std::string CsvField::unescaped() const {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    plain.push_back(text[i]);
    if (has_inner_quotes && text[i] == '"') ++i;
  }
  return plain;
}

bool splitCsvLine(std::string_view line, std::vector<CsvField>& fields, char separator) {
  fields.clear();
  std::size_t at = 0;
  const auto isBlank = [separator](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
  const auto ends = [&](char c) { return separator == ' ' ? isBlank(c) : c == separator; };
  const auto skipBlanks = [&] {
    while (at < line.size() && isBlank(line[at])) ++at;
  };
  while (true) {
    skipBlanks();
    CsvField field;
    field.column = at + 1;
    if (at < line.size() && line[at] == '"') {
      const std::size_t begin = ++at;
      bool closed = false;
      while (at < line.size() && !closed) {
        if (line[at] != '"') {
          ++at;
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
          field.has_inner_quotes = true;
          at += 2;
        } else {
          closed = true;
        }
      }
      field.text = line.substr(begin, at - begin);
      fields.push_back(field);
      if (!closed) return false;
      ++at;
      if (separator != ' ') skipBlanks();
      if (at < line.size() && !ends(line[at])) return false;
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !ends(line[at])) ++at;
      std::size_t end = at;
      while (end > begin && isBlank(line[end - 1])) --end;
      field.text = line.substr(begin, end - begin);
      fields.push_back(field);
    }
    if (separator == ' ') skipBlanks();
    if (at == line.size()) return true;
    if (separator != ' ') ++at;
  }
}

std::optional<std::string_view> takeLine(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace rocinante
