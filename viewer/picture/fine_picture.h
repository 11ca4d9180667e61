#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// How a file keeps its pixels.
struct PictureEncoding {
  int components = 4;     ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; a palette's colours are RGB
  int bits = 8;           ///< of a component: 8 (fewer count as 8) or 16; 16 or 32 when floating
  bool floating = false;  ///< linear light as a rule, not bound to 0..1

  bool operator==(const PictureEncoding&) const = default;
  /// "8 bits a component", "32-bit floating point".
  std::string depthText() const;
  /// "grey", "RGBA".
  std::string_view componentsText() const;
};

/// A picture and what its file holds beyond 8-bit RGBA, for judging.
struct FinePicture {
  Picture picture;  ///< what readPicture() gives
  PictureEncoding encoding;
  /// RGBA of each pixel with the file's own numbers (0..65535 for 16 bits; floating ones as they
  /// are, absent alpha 1 or 65535, absent colours like the grey), where there is more than 8 bits
  /// to know; else empty.
  std::vector<float> samples;
  std::int64_t not_finite = 0;             ///< how many samples are NaN or infinite
  int not_finite_x = 0, not_finite_y = 0;  ///< the first pixel with one
};

/// More pixels of more than 8 bits are not read: their samples would take over a gigabyte.
constexpr std::int64_t kMaxDeepPixels = 1 << 26;

/// Any picture, as readPicture(). unsupported too where a file holds what would go unjudged: more
/// than four components, several pictures, or numbers that a float cannot hold.
Result<FinePicture> readFinePicture(const std::filesystem::path& path,
                                    std::int64_t max_pixels = 1 << 28);
Result<FinePicture> decodeFinePng(ByteView bytes, const std::string& name,
                                  std::int64_t max_pixels = 1 << 28);

}  // namespace rocinante
