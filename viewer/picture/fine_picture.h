#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The pixel format of a file.
struct PictureEncoding {
  int components = 4;     ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; a palette's colours are RGB
  int bits = 8;           ///< per component: 8 (fewer count as 8) or 16; 16 or 32 if floating
  bool floating = false;  ///< usually linear light, not limited to 0..1

  bool operator==(const PictureEncoding&) const = default;
  /// "8 bits per component", "32-bit floating point".
  std::string depthText() const;
  /// "grey", "RGBA".
  std::string_view componentsText() const;
};

/// A picture with its file's data beyond 8-bit RGBA, for judging.
struct FinePicture {
  Picture picture;  ///< as from readPicture()
  PictureEncoding encoding;
  /// EXIF: how viewers show it (orientationText); the pixels are as stored.
  int orientation = 1;
  /// RGBA of each pixel with the file's values (0..65535 for 16 bits; floats unchanged; missing
  /// alpha 1 or 65535; missing colours equal to grey) when the file has more than 8 bits; else
  /// empty.
  std::vector<float> samples;
  std::int64_t not_finite = 0;             ///< number of NaN or infinite samples
  int not_finite_x = 0, not_finite_y = 0;  ///< the first pixel with one
};

/// Limit for more than 8 bits: the samples of more pixels would take over a gigabyte.
constexpr std::int64_t kMaxDeepPixels = 1 << 26;

/// Reads any picture like readPicture(). Also unsupported for data that would not be judged: more
/// than four components, several pictures, or values that a float cannot hold.
Result<FinePicture> readFinePicture(const std::filesystem::path& path,
                                    std::int64_t max_pixels = 1 << 28);
Result<FinePicture> decodeFinePng(ByteView bytes, const std::string& name,
                                  std::int64_t max_pixels = 1 << 28);

}  // namespace rocinante
