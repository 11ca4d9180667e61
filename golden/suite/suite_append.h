#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// A new [[case]]: its keys and TOML values, in order.
struct NewCase {
  std::string name;
  std::vector<std::pair<std::string, std::string>> keys;  ///< without `name`

  void addText(const std::string& key, const std::string& text);
  void addTexts(const std::string& key, const std::vector<std::string>& texts);
  void add(const std::string& key, std::string value);
};

/// The suite with the case appended; existing bytes do not change. bad_argument, with the place,
/// when the result would be invalid: a duplicate name, an invalid value.
Result<std::string> withCase(const std::string& suite, const NewCase& added,
                             const std::filesystem::path& path);

}  // namespace rocinante
