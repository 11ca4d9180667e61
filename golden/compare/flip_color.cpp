#include "golden/compare/flip_color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rocinante::flip {
namespace {

/// Nine numbers, row by row.
using Matrix = std::array<double, 9>;

/// sRGB's primaries and white as exact fractions, each row divided by its sum: X, Y and Z relative
/// to white.
constexpr Matrix relativeXyz() {
  Matrix matrix{10135552, 8788810, 4435075, 2613072, 8788810, 887015, 1425312, 8788810, 70074185};
  for (std::size_t row = 0; row < 9; row += 3) {
    const double sum = matrix[row] + matrix[row + 1] + matrix[row + 2];
    for (std::size_t i = 0; i < 3; ++i) matrix[row + i] /= sum;
  }
  return matrix;
}

constexpr Matrix inverseOf(const Matrix& m) {
  Matrix inverse{m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
                 m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
                 m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]};
  const double determinant = m[0] * inverse[0] + m[1] * inverse[3] + m[2] * inverse[6];
  for (double& value : inverse) value /= determinant;
  return inverse;
}

using FloatMatrix = std::array<float, 9>;

constexpr FloatMatrix asFloats(const Matrix& matrix) {
  FloatMatrix floats{};
  for (std::size_t i = 0; i < matrix.size(); ++i) floats[i] = static_cast<float>(matrix[i]);
  return floats;
}

constexpr FloatMatrix kToXyz = asFloats(relativeXyz());
constexpr FloatMatrix kFromXyz = asFloats(inverseOf(relativeXyz()));

Color multiplied(const FloatMatrix& m, const Color& c) {
  return {m[0] * c.x + m[1] * c.y + m[2] * c.z, m[3] * c.x + m[4] * c.y + m[5] * c.z,
          m[6] * c.x + m[7] * c.y + m[8] * c.z};
}

/// IEC 61966-2-1, for each 8-bit value.
std::array<float, 256> linearTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double encoded = static_cast<double>(i) / 255.0;
    table[i] = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                     : std::pow((encoded + 0.055) / 1.055, 2.4));
  }
  return table;
}

/// CIELAB's cube root, straight near black.
float compressed(float ratio) {
  constexpr float kEdge = 6.0F / 29.0F;
  return ratio > kEdge * kEdge * kEdge ? std::cbrt(ratio)
                                       : ratio / (3 * kEdge * kEdge) + 4.0F / 29.0F;
}

constexpr float kExponent = 0.7F;  // of distances
constexpr float kKnee = 0.4F;      // of the largest distance, below which most of the range lies
constexpr float kAtKnee = 0.95F;

float largestDistance() {
  static const float largest =
      std::pow(distanceOf(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})), kExponent);
  return largest;
}

}  // namespace

Color linearOf(const std::uint8_t* rgb) {
  static const std::array<float, 256> table = linearTable();
  return {table[rgb[0]], table[rgb[1]], table[rgb[2]]};
}

Color opponentOf(const Color& linear) {
  const Color xyz = multiplied(kToXyz, linear);
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

Color linearOfOpponent(const Color& opponent) {
  const float y = (opponent.x + 16) / 116;
  const Color linear = multiplied(kFromXyz, {y + opponent.y / 500, y, y - opponent.z / 200});
  return {std::clamp(linear.x, 0.0F, 1.0F), std::clamp(linear.y, 0.0F, 1.0F),
          std::clamp(linear.z, 0.0F, 1.0F)};
}

Color huntLabOf(const Color& linear) {
  const Color xyz = multiplied(kToXyz, linear);
  const float x = compressed(xyz.x);
  const float y = compressed(xyz.y);
  const float z = compressed(xyz.z);
  const float lightness = 116 * y - 16;
  const float pale = lightness / 100;
  return {lightness, pale * 500 * (x - y), pale * 200 * (y - z)};
}

float distanceOf(const Color& a, const Color& b) {
  const float across = a.y - b.y;
  const float along = a.z - b.z;
  return std::abs(a.x - b.x) + std::sqrt(across * across + along * along);
}

float colorError(float distance) {
  const float largest = largestDistance();
  const float knee = kKnee * largest;
  const float raised = std::pow(distance, kExponent);
  if (raised < knee) return raised * (kAtKnee / knee);
  return std::min(1.0F, kAtKnee + (raised - knee) / (largest - knee) * (1 - kAtKnee));
}

}  // namespace rocinante::flip
