#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/overlay.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The owner of a pixel: a link of a device, or a drawing of the session.
struct IdentityName {
  std::string device;  ///< "drawing" for a drawing (or a device of that name)
  std::string link;    ///< for a drawing "SOURCE/ID"
  bool operator==(const IdentityName&) const = default;
};

/// The device and link shown by each pixel of a frame. One sample per pixel, at its centre, without
/// blending: the nearest surface owns the pixel, even if translucent; texels less than half opaque
/// are holes. Made by FrameMaker::identity(); docs/programs/render.md, section "Identity".
struct IdentityFrame {
  int width = 0;
  int height = 0;
  /// width * height, top row first. 0: no device or drawing; else 1 + an index into `names`.
  std::vector<std::uint32_t> ids;
  /// Owners of at least one pixel: devices and their links in scene order, then drawings.
  std::vector<IdentityName> names;
};

/// Metres from the eye's plane along the view, by pixel.
struct DepthFrame {
  int width = 0;
  int height = 0;
  /// width * height, top row first, of devices only; infinity without one. Negative behind the eye
  /// (visible to orthographic cameras).
  std::vector<float> metres;
};

/// Bounds of the pixels of one name, from the top left, `right` and `bottom` exclusive.
struct IdentityExtent {
  std::uint64_t pixels = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Extents by name.
std::vector<IdentityExtent> extentsOf(const IdentityFrame& frame);

/// 0xRRGGBBFF by name: computed only from the name, so that it is the same in every picture, and
/// never black, which means no owner. When two names collide, the later one gets a different
/// colour.
std::vector<std::uint32_t> identityColors(const std::vector<IdentityName>& names);

/// The frame in these colours, on black.
Picture identityPicture(const IdentityFrame& frame);

/// Numbers the owners of pixels from 1: the links of a scene's devices in order, then its drawings.
/// Plain values, no GL. Borrows the scene.
class IdentityNumbers {
 public:
  explicit IdentityNumbers(const PosedScene& scene);

  std::uint32_t ofLink(std::uint32_t device, std::uint32_t link) const {
    return first_of_device_[device] + link;
  }
  /// Numbers by vertex, from its owner (see addLinesAndPoints()); 0 without an owner.
  std::vector<std::uint32_t> ofVertices(const Overlay& overlay) const;

  /// The frame of these numbers, renumbered without gaps.
  IdentityFrame frame(std::vector<std::uint32_t> numbers, int width, int height) const;

  IdentityName nameOf(std::uint32_t number) const;

 private:
  const PosedScene& scene_;
  std::vector<std::uint32_t> first_of_device_;
  std::uint32_t first_drawing_ = 1;
};

}  // namespace rocinante
