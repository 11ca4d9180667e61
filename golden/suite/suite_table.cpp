#include "golden/suite/suite_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {

void SuiteTable::complain(const TomlNode& node, const std::string& what) {
  if (fault_) return;
  fault_ = Error{ErrorKind::bad_argument, what,
                 fmt::format("{}:{}:{}", file_, node.place.line, node.place.column)};
}

void SuiteTable::onlyKeys(std::initializer_list<std::string_view> allowed) {
  for (const TomlNode::Entry& entry : table_.entries) {
    if (entry.key.starts_with("x-")) continue;
    if (std::ranges::find(allowed, entry.key) == allowed.end()) {
      complain(entry.value, fmt::format("unknown key `{}`", entry.key));
    }
  }
}

const TomlNode* SuiteTable::node(std::string_view key) const {
  const auto found = std::ranges::find(table_.entries, key, &TomlNode::Entry::key);
  return found == table_.entries.end() ? nullptr : &found->value;
}

std::optional<std::string> SuiteTable::text(std::string_view key) {
  const TomlNode* found = ofKind(key, TomlNode::Kind::text, "a string");
  return found != nullptr ? std::optional(found->text) : std::nullopt;
}

std::optional<std::int64_t> SuiteTable::integer(std::string_view key) {
  const TomlNode* found = ofKind(key, TomlNode::Kind::integer, "a whole number");
  return found != nullptr ? std::optional(found->integer) : std::nullopt;
}

std::optional<double> SuiteTable::number(std::string_view key) {
  const TomlNode* found = node(key);
  if (found != nullptr && found->kind == TomlNode::Kind::integer) return found->number;
  found = ofKind(key, TomlNode::Kind::number, "a number");
  return found != nullptr ? std::optional(found->number) : std::nullopt;
}

std::optional<bool> SuiteTable::flag(std::string_view key) {
  const TomlNode* found = ofKind(key, TomlNode::Kind::flag, "true or false");
  return found != nullptr ? std::optional(found->flag) : std::nullopt;
}

std::vector<std::string> SuiteTable::texts(std::string_view key) {
  const TomlNode* found = ofKind(key, TomlNode::Kind::array, "a list of strings");
  std::vector<std::string> texts;
  if (found == nullptr) return texts;
  for (const TomlNode& item : found->items) {
    if (item.kind == TomlNode::Kind::text) {
      texts.push_back(item.text);
    } else {
      complain(item, fmt::format("`{}` is a list of strings", key));
    }
  }
  return texts;
}

std::vector<std::string> SuiteTable::textOrTexts(std::string_view key) {
  const TomlNode* found = node(key);
  if (found == nullptr) return {};
  if (found->kind == TomlNode::Kind::text) return {found->text};
  if (found->kind == TomlNode::Kind::array) return texts(key);
  complain(*found, fmt::format("`{}` is a string or a list of strings", key));
  return {};
}

const TomlNode* SuiteTable::table(std::string_view key) {
  return ofKind(key, TomlNode::Kind::table, "a table");
}

std::string SuiteTable::lineOf(const TomlNode& node) const {
  return fmt::format("{}:{}", file_, node.place.line);
}

const TomlNode* SuiteTable::ofKind(std::string_view key, TomlNode::Kind kind,
                                   std::string_view what) {
  const TomlNode* found = node(key);
  if (found == nullptr || found->kind == kind) return found;
  complain(*found, fmt::format("`{}` is {}", key, what));
  return nullptr;
}

}  // namespace rocinante
