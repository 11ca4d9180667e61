#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace rocinante {

/// Walks the lines of a packet's text and skips what the format ignores: the CR before an LF, blank
/// lines, lines whose first field begins with '#', and NULs at the very end.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {
    while (end_ != at_ && end_[-1] == '\0') --end_;
  }

  /// The next significant line, without its end; leading separators stay, so that columns count
  /// from the line's first byte. False after the last.
  bool next(std::string_view& line) {
    while (at_ != end_) {
      const auto* const feed =
          static_cast<const char*>(std::memchr(at_, '\n', static_cast<std::size_t>(end_ - at_)));
      const char* const line_end = feed == nullptr ? end_ : feed;
      line = {at_, static_cast<std::size_t>(line_end - at_)};
      at_ = feed == nullptr ? end_ : feed + 1;
      ++number_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      std::size_t first = 0;
      while (first < line.size() && (line[first] == ' ' || line[first] == '\t')) ++first;
      if (first < line.size() && line[first] != '#') return true;
    }
    return false;
  }

  /// The number of the line from next(), from 1.
  std::uint32_t number() const { return number_; }

 private:
  const char* at_;
  const char* end_;
  std::uint32_t number_ = 0;
};

/// Walks the fields of one line, which are separated by spaces and tabs.
class TextFields {
 public:
  explicit TextFields(std::string_view line)
      : begin_(line.data()), at_(begin_), end_(begin_ + line.size()) {}

  /// Skips separators; true when nothing is left.
  bool atEnd() {
    while (at_ != end_ && isSeparator(*at_)) ++at_;
    return at_ == end_;
  }
  /// The next field without taking it; empty at the end.
  std::string_view peek() {
    if (atEnd()) return {};
    const char* field_end = at_;
    while (field_end != end_ && !isSeparator(*field_end)) ++field_end;
    return {at_, static_cast<std::size_t>(field_end - at_)};
  }
  std::string_view take() {
    const std::string_view field = peek();
    if (!field.empty()) at_ = field.data() + field.size();
    return field;
  }
  /// Steps over the field returned by peek().
  void skip(std::string_view field) { at_ = field.data() + field.size(); }
  /// Takes the next field when it is `word`.
  bool takeWord(std::string_view word) {
    if (peek() != word) return false;
    at_ += word.size();
    return true;
  }
  /// Takes the next field when it begins with `prefix`, and returns the rest of it.
  bool takeAfter(std::string_view prefix, std::string_view& rest) {
    const std::string_view field = peek();
    if (!field.starts_with(prefix)) return false;
    at_ += field.size();
    rest = field.substr(prefix.size());
    return true;
  }

  /// The position itself, for readers that find the end of a field while reading it.
  const char*& at() { return at_; }
  const char* end() const { return end_; }
  /// True between fields: must hold after a number or string.
  bool atSeparator() const { return at_ == end_ || isSeparator(*at_); }

  std::uint32_t columnOf(const char* place) const {
    return static_cast<std::uint32_t>(place - begin_) + 1;
  }

 private:
  static bool isSeparator(char character) { return character == ' ' || character == '\t'; }

  const char* begin_;
  const char* at_;
  const char* end_;
};

}  // namespace rocinante
