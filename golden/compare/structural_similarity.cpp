#include "golden/compare/structural_similarity.h"

#include <cassert>
#include <cmath>

#include "golden/compare/changed_blocks.h"
#include "golden/compare/plane.h"

namespace rocinante {
namespace {

constexpr int kWindow = 11;
constexpr double kDeviation = 1.5;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

std::vector<double> windowWeights() {
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i < kWindow; ++i) {
    const double from_center = i - (kWindow - 1) / 2.0;
    weights.push_back(std::exp(-from_center * from_center / (2 * kDeviation * kDeviation)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

Plane<double> luminance(const Picture& picture, const PixelBlock& block) {
  Plane<double> plane(block.width(), block.height());
  for (int y = 0; y < plane.height; ++y) {
    const std::uint8_t* from = picture.rgba.data() + (static_cast<std::size_t>(block.top + y) *
                                                          static_cast<std::size_t>(picture.width) +
                                                      static_cast<std::size_t>(block.left)) *
                                                         4;
    double* to = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      const std::uint8_t* pixel = from + x * 4;
      to[x] = 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
    }
  }
  return plane;
}

Plane<double> product(const Plane<double>& a, const Plane<double>& b) {
  Plane<double> result(a.width, a.height);
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = a.values[i] * b.values[i];
  return result;
}

/// The sum of the index over the windows whose upper left pixels are in `windows`.
double sumOfIndex(const Picture& a, const Picture& b, const PixelBlock& windows,
                  std::span<const double> weights) {
  PixelBlock pixels = windows;
  pixels.right += kWindow - 1;
  pixels.bottom += kWindow - 1;
  const Plane<double> plane_a = luminance(a, pixels);
  const Plane<double> plane_b = luminance(b, pixels);
  const auto weighted = [&](const Plane<double>& plane) {
    return filtered<double>(plane, weights, weights);
  };
  const Plane<double> mean_a = weighted(plane_a);
  const Plane<double> mean_b = weighted(plane_b);
  const Plane<double> square_a = weighted(product(plane_a, plane_a));
  const Plane<double> square_b = weighted(product(plane_b, plane_b));
  const Plane<double> mixed = weighted(product(plane_a, plane_b));
  double sum = 0;
  for (std::size_t i = 0; i < mixed.values.size(); ++i) {
    const double ma = mean_a.values[i];
    const double mb = mean_b.values[i];
    const double variance_a = square_a.values[i] - ma * ma;
    const double variance_b = square_b.values[i] - mb * mb;
    const double covariance = mixed.values[i] - ma * mb;
    sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
           ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
  }
  return sum;
}

}  // namespace

std::optional<double> structuralSimilarity(const Picture& a, const Picture& b) {
  assert(a.width == b.width && a.height == b.height);
  // The possible upper left pixels of windows.
  const PixelBlock windows{0, 0, a.width - kWindow + 1, a.height - kWindow + 1};
  if (windows.right <= 0 || windows.bottom <= 0) return std::nullopt;
  const std::vector<double> weights = windowWeights();
  const double all = static_cast<double>(windows.right) * windows.bottom;
  double lost = 0;  // the index is exactly 1 where both are equal
  forEachChangedBlock(a, b, windows, kWindow - 1, [&](const PixelBlock& block) {
    lost += static_cast<double>(block.width()) * block.height() - sumOfIndex(a, b, block, weights);
  });
  return 1 - lost / all;
}

}  // namespace rocinante
