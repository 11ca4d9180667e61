#include "viewer/ui/program/scene_view.h"

#include <chrono>

namespace rocinante {

/// They differ in the detail of a picture that is drawn with everything when it rests.
bool SceneView::isAsGood(const ShownScene& drawn, const ShownScene& wanted) const {
  if (!wanted.terms.refines || !(refined() || plan_.nextAt())) return false;
  ShownScene same = drawn;
  same.terms.rung = wanted.terms.rung;
  same.terms.drops_looks = wanted.terms.drops_looks;
  if (wanted.terms.drops_looks != drawn.terms.drops_looks) {
    same.terms.style.shadows = wanted.terms.style.shadows;
    same.terms.style.contact = wanted.terms.style.contact;
  }
  return same == wanted;
}

Result<std::optional<DrawCounts>> SceneView::draw(Renderer& renderer, SceneFrame frame,
                                                  const ShownScene& shown, SteadyTime now) {
  if (shown_ == shown) return std::optional<DrawCounts>();
  if (shown_ && isAsGood(*shown_, shown)) {
    shown_->terms = shown.terms;
    return std::optional<DrawCounts>();
  }
  shown_.reset();
  const WindowTerms& terms = shown.terms;
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(terms.rung)];
  plain_ = terms.refines && !is_warm_;
  RenderStyle plain_style = terms.style;
  plain_style.shadows = plain_style.contact = false;
  if (plain_) frame.style = &plain_style;
  const int samples = plain_ ? 1 : terms.samples;
  if (auto ready = view_.prepare(renderer.gl(), terms.width, terms.height, samples, rung); !ready) {
    return ready.error();
  }
  auto drawn = view_.draw(renderer, frame);
  if (!drawn.ok()) return drawn.error();
  shown_ = shown;
  plan_.changed(now, plain_ || terms.rung > 0 || terms.drops_looks ? terms.height : 0);
  return std::optional(*drawn);
}

Result<bool> SceneView::refine(Renderer& renderer, const SceneFrame& frame, SteadyTime now) {
  const int rows = shown_ ? plan_.rowsAt(now) : 0;
  if (rows == 0) return false;
  const SteadyTime began = std::chrono::steady_clock::now();
  const WindowTerms& terms = shown_->terms;
  if (auto drawn = rest_.drawRows(renderer, frame, terms.width, terms.height, terms.samples,
                                  plan_.rowsDrawn(), rows);
      !drawn) {
    return drawn.error();
  }
  renderer.gl().Finish();
  plan_.drawn(rows, SteadyTime(std::chrono::steady_clock::now()) - began);
  return plan_.whole();
}

}  // namespace rocinante
