#pragma once

namespace rocinante {

/// The sRGB-encoded value, 0 to 1, of linear light in [0, 1], from + - * / and roots alone: the
/// same bits on every CPU (docs/decisions/003).
double srgbOfLinear(double linear);

}  // namespace rocinante
