#include "golden/compare/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "golden/compare/changed_blocks.h"
#include "golden/compare/flip_color.h"
#include "golden/compare/plane.h"

namespace rocinante {
namespace {

using Kernel = std::vector<float>;
using FloatPlane = Plane<float>;

/// Contrast sensitivity along x degrees (the paper's table 1) is a sum of Gaussians
/// a sqrt(pi / b) exp(-pi^2 x^2 / b): one for the achromatic and the red-green channel, two for
/// the blue-yellow one.
constexpr double kAchromaticB = 0.0047;
constexpr double kRedGreenB = 0.0053;
constexpr double kBlueYellowA1 = 34.1, kBlueYellowB1 = 0.04;
constexpr double kBlueYellowA2 = 13.5, kBlueYellowB2 = 0.025;
constexpr double kWidestB = kBlueYellowB1;

constexpr double kFeatureWidthDegrees = 0.082;  // of the edges and points that are looked for
constexpr float kFeatureExponent = 0.5F;

/// Kernels of one length, 2 * radius + 1.
struct Kernels {
  int radius = 0;
  Kernel achromatic, red_green;
  /// Blue against yellow takes two Gaussians: each runs in both directions, the second is weighted.
  Kernel blue_yellow_1, blue_yellow_2;
  /// A Gaussian and its derivatives; each part of one sign adds up to 1 (the Gaussian as a whole).
  Kernel smooth, edge, point;
};

/// exp(-x^2 / spread) at every tap; those too small to count are left out.
std::vector<double> gaussian(int radius, double spread) {
  std::vector<double> taps;
  for (int i = -radius; i <= radius; ++i) {
    const double value = std::exp(-static_cast<double>(i) * i / spread);
    taps.push_back(value < 1e-9 ? 0 : value);
  }
  return taps;
}

double sumOf(const std::vector<double>& taps) {
  double sum = 0;
  for (const double tap : taps) sum += tap;
  return sum;
}

Kernel scaled(const std::vector<double>& taps, double factor) {
  Kernel kernel;
  for (const double tap : taps) kernel.push_back(static_cast<float>(tap * factor));
  return kernel;
}

/// Positive taps divided by their sum, negative ones by theirs.
Kernel balanced(const std::vector<double>& taps) {
  double above = 0;
  double below = 0;
  for (const double tap : taps) (tap > 0 ? above : below) += std::abs(tap);
  Kernel kernel;
  for (const double tap : taps)
    kernel.push_back(static_cast<float>(tap / (tap > 0 ? above : below)));
  return kernel;
}

/// exp(-pi^2 x^2 / b) with x in degrees is exp(-i^2 / spread) with i in pixels.
double spreadOf(double b, double pixels_per_degree) {
  return b * pixels_per_degree * pixels_per_degree / (std::numbers::pi * std::numbers::pi);
}

Kernel normalized(const std::vector<double>& taps) { return scaled(taps, 1 / sumOf(taps)); }

Kernels makeKernels(double pixels_per_degree) {
  Kernels made;
  const double deviation = std::sqrt(kWidestB / 2) / std::numbers::pi;  // in degrees
  // Wider than the features' radius at any resolution: 0.135 degrees against 0.123.
  made.radius = static_cast<int>(std::ceil(3 * deviation * pixels_per_degree));
  const auto bell = [&](double b) { return gaussian(made.radius, spreadOf(b, pixels_per_degree)); };
  made.achromatic = normalized(bell(kAchromaticB));
  made.red_green = normalized(bell(kRedGreenB));

  const std::vector<double> first = bell(kBlueYellowB1);
  const std::vector<double> second = bell(kBlueYellowB2);
  const double weight_1 = kBlueYellowA1 * std::sqrt(std::numbers::pi / kBlueYellowB1);
  const double weight_2 = kBlueYellowA2 * std::sqrt(std::numbers::pi / kBlueYellowB2);
  const double total =
      weight_1 * sumOf(first) * sumOf(first) + weight_2 * sumOf(second) * sumOf(second);
  made.blue_yellow_1 = scaled(first, std::sqrt(weight_1 / total));
  made.blue_yellow_2 = scaled(second, std::sqrt(weight_2 / total));

  const double feature = 0.5 * kFeatureWidthDegrees * pixels_per_degree;
  const int feature_radius = static_cast<int>(std::ceil(3 * feature));
  std::vector<double> smooth;
  std::vector<double> edge;
  std::vector<double> point;
  for (int i = -made.radius; i <= made.radius; ++i) {
    const double x = i;
    const double value =
        std::abs(i) > feature_radius ? 0 : std::exp(-x * x / (2 * feature * feature));
    smooth.push_back(value);
    edge.push_back(-x * value);
    point.push_back((x * x / (feature * feature) - 1) * value);
  }
  made.smooth = normalized(smooth);
  made.edge = balanced(edge);
  made.point = balanced(point);
  return made;
}

/// One picture's block and its rim in the opponent space.
struct Opponent {
  FloatPlane y, cx, cz;
};

Opponent opponentPlanes(const Picture& picture, const PixelBlock& block, int rim) {
  const int width = block.width() + 2 * rim;
  const int height = block.height() + 2 * rim;
  Opponent planes{{width, height}, {width, height}, {width, height}};
  for (int y = 0; y < height; ++y) {
    const int from_y = std::clamp(block.top + y - rim, 0, picture.height - 1);
    const std::uint8_t* row = picture.rgba.data() + static_cast<std::size_t>(from_y) *
                                                        static_cast<std::size_t>(picture.width) * 4;
    for (int x = 0; x < width; ++x) {
      const int from_x = std::clamp(block.left + x - rim, 0, picture.width - 1);
      const flip::Color color = opponentOf(flip::linearOf(row + from_x * 4));
      planes.y.row(y)[x] = color.x;
      planes.cx.row(y)[x] = color.y;
      planes.cz.row(y)[x] = color.z;
    }
  }
  return planes;
}

FloatPlane blurred(const FloatPlane& plane, const Kernel& across, const Kernel& down) {
  return filtered<float>(plane, across, down);
}

/// The block as an eye at that distance resolves it, in Hunt-adjusted CIELAB.
std::vector<flip::Color> seenColors(const Opponent& planes, const Kernels& kernels) {
  const FloatPlane y = blurred(planes.y, kernels.achromatic, kernels.achromatic);
  const FloatPlane cx = blurred(planes.cx, kernels.red_green, kernels.red_green);
  const FloatPlane cz_1 = blurred(planes.cz, kernels.blue_yellow_1, kernels.blue_yellow_1);
  const FloatPlane cz_2 = blurred(planes.cz, kernels.blue_yellow_2, kernels.blue_yellow_2);
  std::vector<flip::Color> colors(y.values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const flip::Color opponent{y.values[i], cx.values[i], cz_1.values[i] + cz_2.values[i]};
    colors[i] = huntLabOf(linearOfOpponent(opponent));
  }
  return colors;
}

/// How strong an edge and a point are at each pixel.
struct Features {
  FloatPlane edge, point;
};

FloatPlane lengths(const FloatPlane& across, const FloatPlane& down) {
  FloatPlane result(across.width, across.height);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const float x = across.values[i];
    const float y = down.values[i];
    result.values[i] = std::sqrt(x * x + y * y);
  }
  return result;
}

Features featuresOf(FloatPlane y, const Kernels& kernels) {
  for (float& value : y.values) value = (value + 16) / 116;
  return {
      lengths(blurred(y, kernels.edge, kernels.smooth), blurred(y, kernels.smooth, kernels.edge)),
      lengths(blurred(y, kernels.point, kernels.smooth),
              blurred(y, kernels.smooth, kernels.point))};
}

void differenceOfBlock(const Picture& a, const Picture& b, const PixelBlock& block,
                       const Kernels& kernels, Flip& result) {
  const Opponent planes_a = opponentPlanes(a, block, kernels.radius);
  const Opponent planes_b = opponentPlanes(b, block, kernels.radius);
  const std::vector<flip::Color> colors_a = seenColors(planes_a, kernels);
  const std::vector<flip::Color> colors_b = seenColors(planes_b, kernels);
  const Features features_a = featuresOf(planes_a.y, kernels);
  const Features features_b = featuresOf(planes_b.y, kernels);
  std::size_t i = 0;
  for (int y = block.top; y < block.bottom; ++y) {
    float* row =
        result.map.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width);
    for (int x = block.left; x < block.right; ++x, ++i) {
      const float color = flip::colorError(distanceOf(colors_a[i], colors_b[i]));
      const float edge = std::abs(features_a.edge.values[i] - features_b.edge.values[i]);
      const float point = std::abs(features_a.point.values[i] - features_b.point.values[i]);
      const float feature =
          std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kFeatureExponent);
      row[x] = std::pow(color, 1 - feature);
    }
  }
}

}  // namespace

Flip flipDifference(const Picture& a, const Picture& b, double pixels_per_degree) {
  assert(a.width == b.width && a.height == b.height && pixels_per_degree > 0);
  const Kernels kernels = makeKernels(pixels_per_degree);
  Flip result;
  result.map.resize(a.rgba.size() / 4);  // no difference where none is in sight
  forEachChangedBlock(
      a, b, {0, 0, a.width, a.height}, kernels.radius,
      [&](const PixelBlock& block) { differenceOfBlock(a, b, block, kernels, result); });
  double sum = 0;
  for (const float value : result.map) {
    sum += static_cast<double>(value);
    result.max = std::max(result.max, static_cast<double>(value));
  }
  if (!result.map.empty()) result.mean = sum / static_cast<double>(result.map.size());
  return result;
}

}  // namespace rocinante
