#include "viewer/ui/program/warm_up.h"

namespace rocinante {
namespace {

/// Most machines draw it in time, and it costs enough to be measured.
constexpr int kMeasuredRung = 3;

}  // namespace

bool WarmUp::advance(WindowPicture& picture, DetailChoice& detail) {
  if (step_ == Step::done) return false;
  if (step_ == Step::click) {
    static_cast<void>(picture.tryClick());
    step_ = Step::done;
    return true;
  }
  const bool is_chosen = step_ == Step::chosen;
  const auto cost_ms = picture.tryFrame(is_chosen ? detail.rung() : kMeasuredRung,
                                        !is_chosen || detail.dropsLooks());
  if (!cost_ms.ok()) {
    step_ = Step::done;
    return false;
  }
  // The first frame's cost is mostly that of compiling.
  if (step_ == Step::measure) detail.begin(kMeasuredRung, *cost_ms);
  step_ = static_cast<Step>(static_cast<int>(step_) + 1);
  return true;
}

}  // namespace rocinante
