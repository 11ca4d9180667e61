#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "viewer/ui/window/input_queue.h"

namespace rocinante {

/// Parses the name of a key: "E", "shift+H", "ctrl+P", "space", "left", "F1", ","; empty when
/// invalid.
std::optional<KeyPress> parseKey(std::string_view text);
/// The name that parseKey() takes; empty for a key without one.
std::optional<std::string> keyName(const KeyPress& press);

}  // namespace rocinante
