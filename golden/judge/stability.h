#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "golden/compare/picture_mask.h"
#include "golden/judge/case_mask.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A frame that is not the same each time it is drawn.
struct Instability {
  std::int64_t pixels = 0;        ///< that differ between any two of the drawings
  MaskRectangle where;            ///< around them
  bool after_another = false;     ///< it differs when another frame was drawn in between
  bool in_fresh_context = false;  ///< it differs in a context of its own
  PixelSet unstable;              ///< those pixels
};

/// Holds the first drawing against one after another frame and one in a fresh context. Empty when
/// all three are equal.
std::optional<Instability> findInstability(const Picture& first, const Picture& after_another,
                                           const Picture& fresh);

/// "drawn again, 34 pixels at 10,12,8x9 differ: ...", with the likely cause: what had state left in
/// it, and, by `identity` (may be null), whether two parts meet where the pixels lie.
std::string instabilityRule(const Instability& found, const SceneIdentity* identity);

}  // namespace rocinante
