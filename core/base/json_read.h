#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Fields of JSON that a stranger may have written, where a missing field, or one of another type,
// is read as empty. `Tree`: nlohmann::json or ordered_json, whose header the caller includes; it
// need not be an object.

namespace rocinante {

/// null when missing.
template <class Tree>
const Tree& fieldIn(const Tree& object, const char* key) {
  static const Tree kMissing;
  const auto found = object.find(key);
  return found == object.end() ? kMissing : *found;
}

template <class Tree>
const Tree& arrayIn(const Tree& object, const char* key) {
  static const Tree kEmpty = Tree::array();
  const Tree& field = fieldIn(object, key);
  return field.is_array() ? field : kEmpty;
}

template <class Tree>
std::string textIn(const Tree& object, const char* key, std::string otherwise = {}) {
  const Tree& field = fieldIn(object, key);
  return field.is_string() ? field.template get<std::string>() : otherwise;
}

template <class Number, class Tree>
Number numberIn(const Tree& object, const char* key,
                std::type_identity_t<Number> otherwise = Number{}) {
  const Tree& field = fieldIn(object, key);
  return field.is_number() ? field.template get<Number>() : otherwise;
}

/// Skips items that are not texts.
template <class Tree>
std::vector<std::string> textsIn(const Tree& object, const char* key) {
  std::vector<std::string> texts;
  for (const Tree& item : arrayIn(object, key)) {
    if (item.is_string()) texts.push_back(item.template get<std::string>());
  }
  return texts;
}

/// The enumerator that nameOf() calls `name`, of those from 0 to `last`.
template <class Enum>
std::optional<Enum> enumeratorNamed(std::string_view name, Enum last) {
  for (int number = 0; number <= static_cast<int>(last); ++number) {
    const auto one = static_cast<Enum>(number);
    if (nameOf(one) == name) return one;
  }
  return std::nullopt;
}

}  // namespace rocinante
