#include "core/model/toml_node.h"

#include <fmt/format.h>

#include <algorithm>

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace rocinante {
namespace {

Place placeOf(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

// The library bounds the depth of what it parses.
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
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const Place place = placeOf(parsed.error().source());
    return Error{ErrorKind::damaged, std::string(parsed.error().description()),
                 fmt::format("{}:{}:{}", file, place.line, place.column)};
  }
  return nodeOf(parsed.table());
}

}  // namespace rocinante
