#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"

namespace rocinante {

/// The moment of the time line at which the mouse is, and a small picture of it. Plain values.
struct MomentHover {
  std::optional<LogTime> wanted;  ///< of this frame; empty: the mouse is elsewhere
  std::optional<LogTime> drawn;   ///< the moment that the picture shows; empty: there is none
  std::uintptr_t texture = 0;     ///< of GL, top row first
  int width = 0, height = 0;      ///< of the picture, in pixels
};

}  // namespace rocinante
