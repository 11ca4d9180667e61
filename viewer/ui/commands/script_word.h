#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// Any text as one word of a script: blanks, control characters, `#` and `%` become %20 and so on.
std::string scriptWord(std::string_view text);
/// The text that a word means. bad_argument for a % without two digits, NUL, or what is not UTF-8.
Result<std::string> textOfWord(std::string_view word);

/// Mouse buttons in GLFW's order.
constexpr std::array<std::string_view, 5> kMouseButtons{"left", "right", "middle", "fourth",
                                                        "fifth"};

}  // namespace rocinante
