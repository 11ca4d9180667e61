#pragma once

#include <cstdint>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/overlay.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

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
