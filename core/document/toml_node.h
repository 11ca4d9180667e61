#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/fault_list.h"

namespace rocinante {

/// A value of a TOML file with its place. Keeps the heavy TOML library out of our headers, and
/// tables in the order of the file.
struct TomlNode {
  enum class Kind : std::uint8_t { text, integer, number, flag, time, array, table };
  struct Entry;

  Kind kind = Kind::table;
  Place place;
  std::string text;
  double number = 0;  ///< of an integer too
  std::int64_t integer = 0;
  bool flag = false;
  std::vector<TomlNode> items;  ///< of an array
  std::vector<Entry> entries;   ///< of a table
};

struct TomlNode::Entry {
  std::string key;
  Place place;  ///< of the key
  TomlNode value;
};

/// "a string", "a number" and so on, for messages.
std::string_view nameOf(TomlNode::Kind kind);

/// The outermost table of `text`. `damaged` with "FILE:LINE:COLUMN" when it is not TOML.
Result<TomlNode> parseToml(std::string_view text, const std::string& file);

}  // namespace rocinante
