#include "viewer/ui/program/frame_tally.h"

#include <algorithm>
#include <chrono>

namespace rocinante {
namespace {

constexpr Nanoseconds kStillAfter = std::chrono::milliseconds(300);

}  // namespace

std::optional<double> FrameTally::drawn(const std::optional<DrawCounts>& counts, FrameTimes times,
                                        SteadyTime now, ViewerStatus& status) {
  scene_drawn_ = counts.has_value();
  if (!counts) return std::nullopt;
  scene_drawn_at_ = now;
  const auto part = [&](const StageTime& stage) {
    const double ms = std::min(static_cast<double>(stage.wall_ns) / 1e6, times.draw);
    times.draw -= ms;
    return ms;
  };
  times.app += part(counts->times.app);
  times.cull = part(counts->times.cull);
  status.triangles = counts->triangles;
  status.draws = counts->draws;
  status.times.add(times);
  times_ = times;
  return times.total();
}

bool FrameTally::isStill(SteadyTime now) const { return now - scene_drawn_at_ >= kStillAfter; }

void FrameTally::writeDown(ShownFrame frame) {
  frame.shown_at = std::chrono::steady_clock::now();
  frame.shown_wall = std::chrono::system_clock::now();
  frame.drawn = scene_drawn_;
  frame.times = times_;
  journal_.add(frame);
}

}  // namespace rocinante
