#include "viewer/ui/program/warm_up.h"

namespace rocinante {
namespace {

/// Most machines draw it in time, and it costs enough to be measured.
constexpr int kMeasuredRung = 3;

}  // namespace

bool WarmUp::advance(WindowPicture& picture, DetailChoice& detail) {
  if (step_ == Step::done) return false;
  if (step_ == Step::click) {
    static_cast<void>(picture.tryClick(detail.rung()));
    step_ = Step::done;
    return true;
  }
  if (!trial_) trial_ = Trial{kMeasuredRung};
  const auto cost_ms = picture.tryFrame(trial_->rung, trial_->drops_looks);
  if (!cost_ms.ok()) {
    step_ = Step::done;
    return false;
  }
  // The first frame's cost is mostly that of compiling.
  if (is_compiled_) measured(*cost_ms, detail);
  is_compiled_ = !is_compiled_;
  return true;
}

void WarmUp::measured(double cost_ms, DetailChoice& detail) {
  if (is_estimate_) {
    detail.begin(kMeasuredRung, cost_ms);
    const Trial chosen{detail.rung(), detail.dropsLooks()};
    is_estimate_ = false;
    if (chosen.rung == trial_->rung && chosen.drops_looks == trial_->drops_looks) {
      step_ = Step::click;
    } else {
      trial_ = chosen;
    }
    return;
  }
  // Samples may cost far more than was expected of them.
  if (cost_ms > detail.targetMs() && trial_->rung < kMeasuredRung) detail.beginAt(kMeasuredRung);
  if (cost_ms > detail.targetMs() && trial_->rung > kMeasuredRung) {
    detail.begin(trial_->rung, cost_ms);
  }
  step_ = Step::click;
}

}  // namespace rocinante
