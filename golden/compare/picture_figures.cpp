#include "golden/compare/picture_figures.h"

#include <cassert>
#include <cmath>

#include "golden/compare/structural_similarity.h"

namespace rocinante {
namespace {

/// The sum of squared differences of one component.
struct ComponentError {
  std::int64_t squares = 0;
  bool opaque = true;  ///< 255 everywhere in both
};

ComponentError errorOf(const Picture& a, const Picture& b, std::size_t component) {
  ComponentError error;
  for (std::size_t i = component; i < a.rgba.size(); i += 4) {
    const int difference = a.rgba[i] - b.rgba[i];
    error.squares += difference * difference;
    error.opaque = error.opaque && (a.rgba[i] & b.rgba[i]) == 255;
  }
  return error;
}

double rootMeanSquare(const Picture& a, const Picture& b) {
  std::int64_t squares = 0;
  for (std::size_t component = 0; component < 3; ++component) {
    squares += errorOf(a, b, component).squares;
  }
  const ComponentError alpha = errorOf(a, b, 3);
  const double components = alpha.opaque ? 3 : 4;
  squares += alpha.squares;
  const double pixels = static_cast<double>(a.rgba.size() / 4);
  return std::sqrt(static_cast<double>(squares) / (pixels * components));
}

}  // namespace

PictureFigures pictureFigures(const Picture& a, const Picture& b) {
  assert(a.width == b.width && a.height == b.height && !a.rgba.empty());
  PictureFigures figures;
  figures.rmse = rootMeanSquare(a, b);
  if (figures.rmse > 0) figures.psnr = 20 * std::log10(255 / figures.rmse);
  figures.ssim = structuralSimilarity(a, b);
  return figures;
}

}  // namespace rocinante
