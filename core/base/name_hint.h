#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// "did you mean `color`?" when one of `known` is close to `name` (a swap, a slip or two, another
/// case or spelling of the hyphen), else empty. The first of the closest wins.
std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known);

/// The same, or in its place what there is: "there are a, b", "there is only a", "there is none";
/// of many names a few and how many.
std::string whatThereIs(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace rocinante
