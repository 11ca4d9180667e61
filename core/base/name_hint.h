#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// "did you mean `color`?" when one of `known` is close to `name` (a swap, one or two wrong
/// letters, different case or hyphens), else empty. The first of the closest wins.
std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known);

/// The same, or else the known names: "there are a, b", "there is only a", "there is none"; of many
/// names the first few and their number.
std::string whatThereIs(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace rocinante
