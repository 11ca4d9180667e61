#include "viewer/ui/study/moment_study.h"

#include <utility>

#include "core/cell/scene_pose_cache.h"
#include "core/session/timeline.h"

namespace rocinante {

/// Only the worker thread touches it.
class MomentStudy::Poser {
 public:
  explicit Poser(const Cell& cell) : poses_(cell) {}
  std::optional<PosedScene> scene(const Question& question, const std::stop_token& stop);

 private:
  ScenePoseCache poses_;
  std::filesystem::path opened_;
  std::optional<Timeline> timeline_;  // of `opened_`; the last scene borrows from its state
};

std::optional<PosedScene> MomentStudy::Poser::scene(const Question& question,
                                                    const std::stop_token& stop) {
  // A log that grows is opened again for what was not there yet.
  if (!timeline_ || opened_ != question.log || question.moment > timeline_->end()) {
    timeline_.reset();
    auto now = Timeline::open(question.log);
    if (!now.ok()) return std::nullopt;
    timeline_ = std::move(*now);
    timeline_->useStop(stop);
    opened_ = question.log;
  }
  const auto state = timeline_->stateAt(question.moment);
  if (!state.ok()) return std::nullopt;
  return poses_.pose(**state);
}

MomentStudy::MomentStudy(const Cell& cell, std::function<void()> on_ready)
    : worker_(
          [poser = Poser(cell)](const Question& question, const std::stop_token& stop) mutable {
            return poser.scene(question, stop);
          },
          std::move(on_ready)) {}

const PosedScene* MomentStudy::scene() const {
  if (busy()) return nullptr;
  // The worker keeps it until it is asked again.
  const auto found = worker_.found();
  return found && *found ? &**found : nullptr;
}

}  // namespace rocinante
