#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "golden/compare/picture_mask.h"
#include "golden/judge/case_mask.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A frame that differs when it is drawn again.
struct Instability {
  std::int64_t pixels = 0;        ///< that differ between any two drawings
  MaskRectangle where;            ///< their bounding rectangle
  bool after_another = false;     ///< differs after drawing another frame
  bool in_fresh_context = false;  ///< differs in a fresh context
  PixelSet unstable;              ///< those pixels
};

/// Compares the first drawing with one after another frame and one in a fresh context. Empty when
/// all three are equal.
std::optional<Instability> findInstability(const Picture& first, const Picture& after_another,
                                           const Picture& fresh);

/// "drawn again, 34 pixels at 10,12,8x9 differ: ...", with the likely cause: leftover state, or, by
/// `identity` (may be null), two parts that touch at these pixels.
std::string instabilityRule(const Instability& found, const SceneIdentity* identity);

}  // namespace rocinante
