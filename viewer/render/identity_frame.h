#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// What a pixel can belong to: a link of a device, or one of the session's drawings.
struct IdentityName {
  std::string device;  ///< "drawing" for what a source drew (no device can be told from it then)
  std::string link;    ///< of a drawing "SOURCE/ID"
  bool operator==(const IdentityName&) const = default;
};

/// Which device and link a frame shows where: what identifies its pixels, not what they look like.
/// One sample a pixel, at its centre, and no blending: the nearest surface has the pixel, however
/// translucent it is; of textures with holes what is less than half opaque is a hole. Made by
/// FrameMaker::identity(); docs/programs/render.md, section "Identity".
struct IdentityFrame {
  int width = 0;
  int height = 0;
  /// width * height, top row first. 0: nothing of a device or drawing; else 1 + a place in `names`.
  std::vector<std::uint32_t> ids;
  /// Those that have a pixel, devices and their links in the order of the scene, then drawings.
  std::vector<IdentityName> names;
};

/// Metres from the eye's plane along the view, by pixel.
struct DepthFrame {
  int width = 0;
  int height = 0;
  /// width * height, top row first, of devices alone; infinity where there is none. Behind the eye
  /// (orthographic cameras see that too) it is negative.
  std::vector<float> metres;
};

/// Where the pixels of one name lie: pixels from the top left, `right` and `bottom` exclusive.
struct IdentityExtent {
  std::uint64_t pixels = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// By name.
std::vector<IdentityExtent> extentsOf(const IdentityFrame& frame);

/// 0xRRGGBBFF by name: made from the name alone, so that it is the same in every picture, and never
/// black, which means nothing. Of two names that would get one colour, the later one gets another.
std::vector<std::uint32_t> identityColors(const std::vector<IdentityName>& names);

/// The frame in these colours, on black.
Picture identityPicture(const IdentityFrame& frame);

}  // namespace rocinante
