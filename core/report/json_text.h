#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/report/json_name.h"

namespace rocinante {

/// JSON as programs print it, with LF. Names, payloads and paths come from strangers and need not
/// be UTF-8: what is not becomes U+FFFD. `indent`: spaces a level; -1: all on one line.
std::string jsonText(const Json& json, int indent = 2);

/// null when empty.
template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}
inline Json orNull(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

}  // namespace rocinante
