#pragma once

#include <string>

namespace rocinante {

/// An angle for people: "23.6°", six significant digits. Files and JSON keep radians.
std::string angleText(double radians);

}  // namespace rocinante
