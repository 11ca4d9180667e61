#pragma once

#include <optional>

#include "viewer/picture/picture.h"

namespace rocinante {

/// Common measures of the difference of two pictures of one shape. None decides a verdict: each
/// spreads a small fault over the whole picture (docs/comparing-pictures.md).
struct PictureFigures {
  double rmse = 0;  ///< over R, G and B, and A when either picture is not opaque; 0 to 255
  std::optional<double> psnr;  ///< 20 log10(255 / rmse), in dB; empty: infinite, for rmse 0
  std::optional<double> ssim;  ///< structuralSimilarity()
};

PictureFigures pictureFigures(const Picture& a, const Picture& b);

}  // namespace rocinante
