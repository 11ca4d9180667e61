#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Finite numbers separated by spaces or commas, as people type them: "0 -0.785, 1e-3 +2".
/// bad_argument naming the first invalid one.
Result<std::vector<double>> parseNumbers(std::string_view text);

}  // namespace rocinante
