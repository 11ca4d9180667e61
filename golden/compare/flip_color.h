#pragma once

#include <cstdint>

// The colour spaces of FLIP (golden/compare/flip.h), section 4.1 of the paper, under illuminant
// D65.

namespace rocinante::flip {

/// Three coordinates of a colour; which, the function says.
struct Color {
  float x = 0, y = 0, z = 0;
};

/// Linear RGB, 0 to 1, of an 8-bit sRGB pixel.
Color linearOf(const std::uint8_t* rgb);
/// Opponent space (Y, Cx, Cz), linear in light, in which contrast sensitivity is known:
/// Y = 116 y - 16, Cx = 500 (x - y), Cz = 200 (y - z), with x y z relative to white.
Color opponentOf(const Color& linear);
/// Back, and into the gamut: every component from 0 to 1.
Color linearOfOpponent(const Color& opponent);
/// CIELAB with a and b scaled by L / 100: colours look paler in the dark (Hunt).
Color huntLabOf(const Color& linear);
/// |dL| + |(da, db)|: the HyAB distance, made for colours that are far apart.
float distanceOf(const Color& a, const Color& b);

/// A distance as the paper maps it to 0..1: raised to 0.7, what is below 0.4 of the largest
/// possible (green against blue) takes 0..0.95, the rest what remains.
float colorError(float distance);

}  // namespace rocinante::flip
