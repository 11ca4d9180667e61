#pragma once

#include <optional>

#include "core/report/finding.h"

namespace rocinante {

/// How bad a finding is, for rules whose sentence states an angle, a distance or a speed: larger is
/// worse, in the unit of the sentence. Empty for all others; never a count or a time.
std::optional<double> worstValue(const Finding& finding);

}  // namespace rocinante
