#pragma once

namespace rocinante {

/// A calibrated lens without distortion, by OpenCV's pinhole model: a point (x right, y down, z
/// forward) projects to pixel (fx x / z + cx, fy y / z + cy) of a picture of this size.
/// Whole numbers are the centres of pixels; 0, 0 is the upper left one.
struct CameraIntrinsics {
  double fx = 1, fy = 1, cx = 0, cy = 0;
  int width = 1, height = 1;
  bool operator==(const CameraIntrinsics&) const = default;
};

/// How a real lens bends pictures: OpenCV's first five coefficients. All zero: not at all.
struct LensDistortion {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;
  bool operator==(const LensDistortion&) const = default;
};

/// Limits of CameraIntrinsics, of a side and of the whole picture.
inline constexpr int kMaxLensSide = 16384, kMaxLensPixels = 7680 * 4320;

}  // namespace rocinante
