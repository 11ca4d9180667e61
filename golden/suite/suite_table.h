#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/toml_node.h"

namespace rocinante {

/// Strict reader of one table of a suite. Keeps the first fault of the whole file, with line and
/// column. Borrows the table, the file's name and the fault.
class SuiteTable {
 public:
  SuiteTable(const TomlNode& table, const std::string& file, std::optional<Error>& fault)
      : table_(table), file_(file), fault_(fault) {}

  void complain(const TomlNode& node, const std::string& what);
  void complainHere(const std::string& what) { complain(table_, what); }
  /// Any other key is a fault, except x-*.
  void onlyKeys(std::initializer_list<std::string_view> allowed);

  bool has(std::string_view key) const { return node(key) != nullptr; }
  /// Null when the table has no such key.
  const TomlNode* node(std::string_view key) const;
  /// Empty when the key is missing; a wrong type is a fault.
  std::optional<std::string> text(std::string_view key);
  std::optional<std::int64_t> integer(std::string_view key);
  std::optional<double> number(std::string_view key);
  std::optional<bool> flag(std::string_view key);
  std::vector<std::string> texts(std::string_view key);
  /// A string, or a list of them.
  std::vector<std::string> textOrTexts(std::string_view key);
  /// The table below `key`, or null.
  const TomlNode* table(std::string_view key);

  /// "s.toml:12".
  std::string lineOf(const TomlNode& node) const;
  const std::string& file() const { return file_; }
  std::optional<Error>& fault() { return fault_; }

 private:
  const TomlNode* ofKind(std::string_view key, TomlNode::Kind kind, std::string_view what);

  const TomlNode& table_;
  const std::string& file_;
  std::optional<Error>& fault_;
};

}  // namespace rocinante
