#pragma once

namespace rocinante {

/// A distance as reports and tables have it: rounded to 0.01 mm, in metres. Only what penetrates is
/// 0: what does not is 0.01 mm at least.
double roundedClearance(double metres);

}  // namespace rocinante
