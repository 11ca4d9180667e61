#include "viewer/ui/study/parting_study.h"

#include <algorithm>
#include <utility>

#include "core/cell/scene_pose_cache.h"
#include "core/session/timeline.h"
#include "viewer/view/beside_session.h"

namespace rocinante {
namespace {

/// An hour at kPartingStep.
constexpr std::int64_t kMaxSamples = 180'000;
/// Samples between two times that news are shown.
constexpr std::int64_t kSamplesAtATime = 256;

void addDevices(std::vector<std::string>& all, const std::vector<std::string>& more) {
  for (const std::string& device : more) {
    const auto place = std::ranges::lower_bound(all, device);
    if (place == all.end() || *place != device) all.insert(place, device);
  }
}

}  // namespace

Status PartingStudy::look(const Cell& cell, const Question& question, const std::stop_token& stop,
                          std::vector<Parting>& partings) {
  auto shown = Timeline::open(question.shown);
  if (!shown.ok()) return shown.error();
  auto opened = Timeline::open(question.beside);
  if (!opened.ok()) return opened.error();
  shown->useStop(stop);
  opened->useStop(stop);
  ScenePoseCache poses(cell);
  BesideSession beside(cell, std::move(*opened), question.alignment);
  const LogTime start = shown->start();
  const Nanoseconds length = shown->end() - start;
  const Nanoseconds step = std::max(kPartingStep, length / kMaxSamples + Nanoseconds(1));
  StateDamage ignored;  // pictures show where it is
  bool apart = false;
  for (std::int64_t i = 0; start + (i - 1) * step < shown->end(); ++i) {
    if (stop.stop_requested()) return {};
    if (i % kSamplesAtATime == 0 && partings != found()) worker_.publish({partings, {}});
    const LogTime moment = std::min(start + i * step, shown->end());
    if (!beside.covers(moment)) {
      apart = false;
      continue;
    }
    const auto state = shown->stateAt(moment, &ignored);
    if (!state.ok()) return state.error();
    PosedScene scene = poses.pose(**state);
    if (Status added = beside.addGhosts(scene, moment, ignored); !added) return added;
    const bool was_apart = std::exchange(apart, !beside.elsewhere().empty());
    if (!apart) continue;
    if (!was_apart) partings.push_back({moment, moment, {}});
    partings.back().until = moment;
    addDevices(partings.back().devices, beside.elsewhere());
  }
  return {};
}

PartingStudy::PartingStudy(const Cell& cell, std::filesystem::path shown,
                           std::filesystem::path beside, EventAlignment alignment)
    : worker_([this, &cell](const Question& question, const std::stop_token& stop) {
        Answer answer;
        const Status looked = look(cell, question, stop, answer.partings);
        if (!looked) answer.fault = looked.error().text();
        return answer;
      }) {
  worker_.ask({std::move(shown), std::move(beside), std::move(alignment)});
}

std::vector<Parting> PartingStudy::found() const {
  const auto found = worker_.found();
  return found ? found->partings : std::vector<Parting>();
}

std::string PartingStudy::fault() const {
  const auto found = worker_.found();
  return found ? found->fault : std::string();
}

std::optional<LogTime> PartingStudy::beside(LogTime moment, bool after) const {
  const std::vector<Parting> found = this->found();
  const auto next = after ? std::ranges::upper_bound(found, moment, {}, &Parting::from)
                          : std::ranges::lower_bound(found, moment, {}, &Parting::from);
  if (after) return next == found.end() ? std::nullopt : std::optional(next->from);
  return next == found.begin() ? std::nullopt : std::optional(std::prev(next)->from);
}

}  // namespace rocinante
