#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

/// What a text looks like that is not read as it is, and how to make one of it that is: UTF-16, one
/// array of JSON, lines that end with CR alone, columns between bars. Empty for any other text.
/// `text`: the first bytes of a file.
std::optional<std::string> textRefusal(std::string_view text);

}  // namespace rocinante
