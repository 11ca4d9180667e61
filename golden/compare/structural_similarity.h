#pragma once

#include <optional>

#include "viewer/picture/picture.h"

namespace rocinante {

/// The mean structural similarity index of two pictures of one shape: Wang, Bovik, Sheikh,
/// Simoncelli, "Image quality assessment: from error visibility to structural similarity", IEEE
/// Transactions on Image Processing 13(4), 2004. 1 for equal pictures, down to -1.
///
/// As in the paper: 11x11 Gaussian window of standard deviation 1.5 whose weights add up to 1, at
/// every pixel where it lies wholly inside; C1 = (0.01 * 255)^2, C2 = (0.03 * 255)^2; the mean of
///   (2 ma mb + C1)(2 sab + C2) / ((ma^2 + mb^2 + C1)(sa^2 + sb^2 + C2))
/// over all windows. The index is of luminance, 0.299 R + 0.587 G + 0.114 B of the encoded values
/// (Rec. 601); alpha is ignored, and the picture is not reduced first. Empty when a side is shorter
/// than 11 pixels, the window.
std::optional<double> structuralSimilarity(const Picture& a, const Picture& b);

}  // namespace rocinante
