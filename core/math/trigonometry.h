#pragma once

namespace rocinante {

/// Trigonometry that gives the same bits on every CPU: nothing but + - * / sqrt and integers
/// (docs/decisions/003). The C library's own differs between CPUs with and without FMA.
///
/// Angles are radians, any finite double however large: arguments are reduced with as many digits
/// of pi as they need. sine, cosine and the arc functions are within one unit in the last place of
/// the true value, tangent within three. NaN and infinite angles give NaN; signed zeros are kept;
/// sine(-x) == -sine(x) and cosine(-x) == cosine(x) exactly. Pure; any thread.

inline constexpr double kPi = 0x1.921fb54442d18p+1;

struct SineCosine {
  double sine;
  double cosine;
};
/// Computes both from one reduction of the argument.
SineCosine sineCosine(double angle_rad);

double sine(double angle_rad);
double cosine(double angle_rad);
double tangent(double angle_rad);

/// In [-pi/2, pi/2]; NaN outside [-1, 1].
double arcSine(double value);
/// In [0, pi]; NaN outside [-1, 1].
double arcCosine(double value);
/// In [-pi/2, pi/2].
double arcTangent(double value);
/// The angle of (x, y) in [-pi, pi], with the special cases of IEC 60559's atan2.
double arcTangent2(double y, double x);

constexpr double radiansOf(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degreesOf(double radians) { return radians * (180.0 / kPi); }

}  // namespace rocinante
