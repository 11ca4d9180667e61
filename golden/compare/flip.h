#pragma once

#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// How many pixels one degree of the field of view covers for who sits 0.7 m before a screen that
/// is 0.7 m and 3,840 pixels wide: 0.7 * 3840 / 0.7 * pi / 180. The paper's own choice.
constexpr double kFlipPixelsPerDegree = 67.02064327658225;

/// What somebody sees who flips between two pictures: Andersson, Nilsson, Akenine-Moller,
/// Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
/// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020; the variant
/// for pictures of low dynamic range.
struct Flip {
  double mean = 0;         ///< over all pixels; the paper's single figure. 0 to 1
  double max = 0;          ///< of any pixel
  std::vector<float> map;  ///< of each pixel, rows top to bottom
};

/// Both pictures are of one shape and taken as sRGB; alpha is not looked at. The border repeats
/// outwards. Symmetric in its pictures.
Flip flipDifference(const Picture& a, const Picture& b,
                    double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace rocinante
