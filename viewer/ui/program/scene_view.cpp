#include "viewer/ui/program/scene_view.h"

#include <chrono>

namespace rocinante {

Result<std::optional<DrawCounts>> SceneView::draw(Renderer& renderer, SceneFrame frame,
                                                  const ShownScene& shown, SteadyTime now) {
  if (shown_ == shown) return std::optional<DrawCounts>();
  shown_.reset();
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(shown.rung)];
  plain_ = shown.begins_plain && !begun_;
  RenderStyle plain_style = shown.style;
  plain_style.shadows = plain_style.contact = false;
  if (plain_) frame.style = &plain_style;
  const int samples = plain_ ? 1 : shown.samples;
  if (auto ready = view_.prepare(renderer.gl(), shown.width, shown.height, samples, rung); !ready) {
    return ready.error();
  }
  auto drawn = view_.draw(renderer, frame);
  if (!drawn.ok()) return drawn.error();
  shown_ = shown;
  begun_ = true;
  plan_.changed(now, plain_ || shown.rung > 0 || shown.drops_looks ? shown.height : 0);
  return std::optional(*drawn);
}

Result<bool> SceneView::refine(Renderer& renderer, const SceneFrame& frame, SteadyTime now) {
  const int rows = shown_ ? plan_.rowsAt(now) : 0;
  if (rows == 0) return false;
  const SteadyTime began = std::chrono::steady_clock::now();
  if (auto drawn = rest_.drawRows(renderer, frame, shown_->width, shown_->height, shown_->samples,
                                  plan_.rowsDrawn(), rows);
      !drawn) {
    return drawn.error();
  }
  renderer.gl().Finish();
  plan_.drawn(rows, SteadyTime(std::chrono::steady_clock::now()) - began);
  return plan_.whole();
}

}  // namespace rocinante
