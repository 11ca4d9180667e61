#include "core/document/toml_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

// The library asserts conditions that a file can break (a header `[= 1]`), and with NDEBUG lets
// clang assume them. The code after each assertion refuses the text properly, so both are disabled.
#undef NDEBUG
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 64
#include <toml++/toml.h>

namespace rocinante {
namespace {

Place placeOf(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

/// Each dot of a key opens a table, and the library bounds only the depth of values: it recurses
/// through the parts of a key. No real cell has more parts than this.
constexpr std::size_t kMaxKeyDots = 16;

/// The offset behind the string that begins at `at`.
std::size_t endOfString(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool is_long = text.substr(at, 3) == three;
  for (at += is_long ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (is_long && text.substr(at, 3) == three) {
      at += 3;
      // Up to two quotes of the string itself may precede the three that close it.
      for (int own = 0; own < 2 && at < text.size() && text[at] == quote; ++own) ++at;
      return at;
    } else if (!is_long && (text[at] == quote || text[at] == '\n')) {
      return at + (text[at] == quote ? 1 : 0);
    }
  }
  return text.size();
}

struct TextFault {
  std::string what;
  std::size_t at = 0;
};

/// Mistakes that would crash the library: a key of too many parts, and a letter beyond ASCII
/// outside strings and comments, for which its Unicode tables have paths that it declares
/// unreachable.
std::optional<TextFault> faultBeforeParsing(std::string_view text) {
  const auto is_of_key = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == ' ' || c == '\t';
  };
  std::size_t dots = 0;
  const bool has_mark = text.substr(0, 3) == "\xEF\xBB\xBF";
  for (std::size_t at = has_mark ? 3 : 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = endOfString(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      dots = 0;
      continue;
    }
    if (static_cast<unsigned char>(c) >= 0x80) {
      return TextFault{"letters beyond ASCII must be in quotes", at};
    }
    if (c == '.') {
      if (++dots > kMaxKeyDots) {
        return TextFault{fmt::format("a key has more than {} parts", kMaxKeyDots + 1), at};
      }
    } else if (!is_of_key(c)) {
      dots = 0;
    }
    ++at;
  }
  return std::nullopt;
}

/// The text with an x for each letter beyond ASCII, on the same lines and columns. In malformed
/// text (`k = 2v"` and such a letter) strings begin elsewhere for the library than for
/// faultBeforeParsing(); what it accepts so has them only in strings and comments.
std::string inAscii(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string ascii(text.starts_with(kMark) ? kMark : std::string_view());
  for (const char c : text.substr(ascii.size())) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) ascii += c;
    if (byte >= 0xC0) ascii += 'x';
  }
  return ascii;
}

/// Line and column of an offset, both from 1, columns in code points.
Place placeOf(std::string_view text, std::size_t offset) {
  Place place{1, 1};
  for (const char c : text.substr(0, offset)) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (c == '\n') {
      place = {place.line + 1, 1};
    } else if (!continues) {
      ++place.column;
    }
  }
  return place;
}

// Neither the library nor faultBeforeParsing() lets more than a thousand levels through.
TomlNode nodeOf(const toml::node& from) {
  TomlNode node;
  node.place = placeOf(from.source());
  if (const auto* text = from.as_string()) {
    node.kind = TomlNode::Kind::text;
    node.text = text->get();
  } else if (const auto* integer = from.as_integer()) {
    node.kind = TomlNode::Kind::integer;
    node.integer = integer->get();
    node.number = static_cast<double>(integer->get());
  } else if (const auto* number = from.as_floating_point()) {
    node.kind = TomlNode::Kind::number;
    node.number = number->get();
  } else if (const auto* flag = from.as_boolean()) {
    node.kind = TomlNode::Kind::flag;
    node.flag = flag->get();
  } else if (const auto* array = from.as_array()) {
    node.kind = TomlNode::Kind::array;
    node.items.reserve(array->size());
    for (const toml::node& item : *array) node.items.push_back(nodeOf(item));
  } else if (const auto* table = from.as_table()) {
    node.kind = TomlNode::Kind::table;
    for (const auto& [key, value] : *table) {
      node.entries.push_back({std::string(key.str()), placeOf(key.source()), nodeOf(value)});
    }
    // The library sorts by key; faults are listed as the file has them.
    std::stable_sort(node.entries.begin(), node.entries.end(), [](const auto& a, const auto& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
  } else {
    node.kind = TomlNode::Kind::time;
  }
  return node;
}

}  // namespace

std::string_view nameOf(TomlNode::Kind kind) {
  switch (kind) {
    case TomlNode::Kind::text:
      return "a string";
    case TomlNode::Kind::integer:
      return "an integer";
    case TomlNode::Kind::number:
      return "a number";
    case TomlNode::Kind::flag:
      return "true or false";
    case TomlNode::Kind::time:
      return "a date or time";
    case TomlNode::Kind::array:
      return "an array";
    case TomlNode::Kind::table:
      return "a table";
  }
  return "a value";
}

Result<TomlNode> parseToml(std::string_view text, const std::string& file) {
  if (const std::optional<TextFault> fault = faultBeforeParsing(text)) {
    const Place place = placeOf(text, fault->at);
    return Error{ErrorKind::damaged, fault->what,
                 fmt::format("{}:{}:{}", file, place.line, place.column)};
  }
  const std::string ascii = inAscii(text);
  toml::parse_result parsed = toml::parse(ascii);
  if (parsed && ascii != text) parsed = toml::parse(text);
  if (!parsed) {
    const Place place = placeOf(parsed.error().source());
    std::string what(parsed.error().description());
    if (what.find("TOML_MAX_NESTED_VALUES") != what.npos) {
      what = fmt::format("values are nested deeper than {}", TOML_MAX_NESTED_VALUES);
    }
    return Error{ErrorKind::damaged, std::move(what),
                 fmt::format("{}:{}:{}", file, place.line, place.column)};
  }
  return nodeOf(parsed.table());
}

}  // namespace rocinante
