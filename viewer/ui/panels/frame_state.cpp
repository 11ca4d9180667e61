#include "viewer/ui/panels/frame_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rocinante {

std::string frameStateText(FrameState state, double frame_ms, double target_fps) {
  if (state == FrameState::at_rest) return "at rest";
  if (state == FrameState::refining) return "refining";
  const double rate = std::min(1000 / std::max(frame_ms, 0.01), target_fps);
  return rate < 1 ? "drawing slowly" : fmt::format("drawing {:.0f}/s", std::floor(rate));
}

std::string frameCostText(double frame_ms) {
  if (frame_ms >= 1000) return fmt::format("{:.1f} s a frame", frame_ms / 1000);
  return fmt::format("{:.1f} ms, {:.{}f} frames/s", frame_ms, 1000 / std::max(frame_ms, 0.01),
                     frame_ms > 100 ? 1 : 0);
}

}  // namespace rocinante
