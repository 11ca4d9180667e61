#include "core/math/trigonometry.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math/angle_reduction.h"

namespace rocinante {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// Below this angle its cube is lost when added to it.
constexpr double kTinyAngle = 0x1p-27;

// A value in two doubles: `low` is the part that `high` cannot hold.
struct Pair {
  double high;
  double low;
};

constexpr Pair kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Pair kWholePi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

Pair sumOf(double a, double b) {  // exact
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

Pair halvesOf(double value) {  // 26 digits each; exact below 2^996
  const double scaled = value * 134217729.0;
  const double high = scaled - (scaled - value);
  return {high, value - high};
}

Pair productOf(double a, double b) {  // exact, unless it underflows
  const double product = a * b;
  const Pair x = halvesOf(a), y = halvesOf(b);
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

Pair sumOf(const Pair& a, const Pair& b) {
  const Pair sum = sumOf(a.high, b.high);
  return sumOf(sum.high, sum.low + (a.low + b.low));
}

Pair negated(const Pair& a) { return {-a.high, -a.low}; }

// Taylor terms on [-pi/4, pi/4]: the first one omitted is below 2^-63 of the result.
double sineNearZero(const ReducedAngle& r) {
  const double z = r.high * r.high;
  const double tail =
      1.0 / 120 +
      z * (-1.0 / 5040 +
           z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 +
                                                           z * (-1.0 / 1307674368000.0 +
                                                                z * (1.0 / 355687428096000.0))))));
  return r.high + (r.high * z * (-1.0 / 6 + z * tail) + r.low * (1.0 - 0.5 * z));
}

double cosineNearZero(const ReducedAngle& r) {
  const double z = r.high * r.high;
  const double tail =
      1.0 / 24 +
      z * (-1.0 / 720 +
           z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                   z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 +
                                                                 z * (1.0 / 20922789888000.0))))));
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  // (1 - head) - half is the part that rounding `head` lost.
  return head + (((1.0 - head) - half) + (z * z * tail - r.high * r.low));
}

// atan(k / 16)
constexpr std::array<Pair, 17> kArcTangents = {{
    {0.0, 0.0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
}};

// atan(y / x) for 0 <= y <= x, x > 0, neither near overflow or underflow.
Pair arcTangentOfRatio(const Pair& y, const Pair& x) {
  // tan(a - b) = (y - cx) / (x + cy) with c = tan b the nearest sixteenth: at most 1/31.
  const auto nearest = static_cast<std::size_t>(16.0 * (y.high / x.high) + 0.5);
  const double c = static_cast<double>(nearest) / 16.0;
  const Pair cx = productOf(c, x.high), cy = productOf(c, y.high);
  const Pair above = sumOf(y, {-cx.high, -(cx.low + c * x.low)});
  const Pair below = sumOf(x, {cy.high, cy.low + c * y.low});

  const double t = above.high / below.high;
  const Pair back = productOf(t, below.high);
  const double rest = ((above.high - back.high) - back.low) + (above.low - t * below.low);
  const double t_low = rest / below.high;

  const double z = t * t;
  const double tail =
      -1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13)))));
  return sumOf(kArcTangents[nearest], {t, t_low + t * z * tail});
}

// The angle in [0, pi/2] of a point with y, x >= 0, not both zero.
Pair firstQuadrantAngle(const Pair& y, const Pair& x) {
  if (y.high <= x.high) return arcTangentOfRatio(y, x);
  return sumOf(kHalfPi, negated(arcTangentOfRatio(x, y)));
}

int exponentOf(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff);
}

// sqrt(1 - value^2), value in [-1, 1].
Pair otherLeg(double value) {
  const Pair square = productOf(value, value);
  const Pair rest = sumOf(sumOf(1.0, -square.high), {-square.low, 0.0});
  if (rest.high <= 0.0) return {0.0, 0.0};
  const double root = std::sqrt(rest.high);
  const Pair back = productOf(root, root);
  return {root, (((rest.high - back.high) - back.low) + rest.low) / (2.0 * root)};
}

}  // namespace

SineCosine sineCosine(double angle_rad) {
  const double angle = std::fabs(angle_rad);
  if (!(angle < std::numeric_limits<double>::infinity())) return {kNan, kNan};
  if (angle < kTinyAngle) return {angle_rad, 1.0};
  const ReducedAngle reduced = reduceAngle(angle);
  double s = sineNearZero(reduced);
  double c = cosineNearZero(reduced);
  if (reduced.quadrant % 2 != 0) {
    const double turned = -s;
    s = c;
    c = turned;
  }
  if (reduced.quadrant >= 2) {
    s = -s;
    c = -c;
  }
  return {angle_rad < 0 ? -s : s, c};
}

double sine(double angle_rad) { return sineCosine(angle_rad).sine; }

double cosine(double angle_rad) { return sineCosine(angle_rad).cosine; }

double tangent(double angle_rad) {
  const SineCosine both = sineCosine(angle_rad);
  return both.sine / both.cosine;
}

double arcSine(double value) {
  const double size = std::fabs(value);
  if (!(size <= 1.0)) return kNan;
  if (size < kTinyAngle) return value;
  const double angle = firstQuadrantAngle({size, 0.0}, otherLeg(size)).high;
  return value < 0 ? -angle : angle;
}

double arcCosine(double value) {
  const double size = std::fabs(value);
  if (!(size <= 1.0)) return kNan;
  if (size < 0x1p-60) return kHalfPi.high;
  const Pair angle = firstQuadrantAngle(otherLeg(size), {size, 0.0});
  return value < 0 ? sumOf(kWholePi, negated(angle)).high : angle.high;
}

double arcTangent(double value) { return arcTangent2(value, 1.0); }

double arcTangent2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  double tall = std::fabs(y), wide = std::fabs(x);
  const bool leftward = std::signbit(x);
  Pair angle{0.0, 0.0};
  const int steep = exponentOf(tall) - exponentOf(wide);
  if (std::isinf(tall) && std::isinf(wide)) {
    angle = kArcTangents[16];
  } else if (tall == 0.0 || std::isinf(wide)) {
    angle = {0.0, 0.0};
  } else if (wide == 0.0 || std::isinf(tall) || steep > 64) {
    angle = kHalfPi;
  } else if (steep < -64) {
    angle = {tall / wide, 0.0};  // its cube is lost beside it
  } else {
    // Scaled so that no product overflows or loses digits. Exact: powers of two; subnormal numbers
    // take a second pass.
    for (int turn = 0; turn < 2; ++turn) {
      const int largest = exponentOf(tall > wide ? tall : wide);
      const int raise = largest > 1500 ? -512 : largest < 500 ? 512 : 0;
      const double factor = raise < 0 ? 0x1p-512 : raise > 0 ? 0x1p512 : 1.0;
      tall *= factor;
      wide *= factor;
    }
    angle = firstQuadrantAngle({tall, 0.0}, {wide, 0.0});
  }
  if (leftward) angle = sumOf(kWholePi, negated(angle));
  return std::signbit(y) ? -angle.high : angle.high;
}

}  // namespace rocinante
