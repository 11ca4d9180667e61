#include "viewer/ui/study/parting_study.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "core/cell/scene_pose_cache.h"
#include "core/session/timeline.h"
#include "viewer/ui/study/study_thread.h"
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

struct PartingStudy::Impl {
  Impl(const Cell& the_cell, std::filesystem::path a, std::filesystem::path b,
       EventAlignment aligned)
      : cell(the_cell),
        shown_log(std::move(a)),
        beside_log(std::move(b)),
        alignment(std::move(aligned)) {}

  Status look(const std::stop_token& stop);
  void publish(std::vector<Parting> partings) {
    const std::lock_guard lock(mutex);
    if (partings == found) return;
    found = std::move(partings);
    news = true;
  }

  const Cell& cell;
  std::filesystem::path shown_log, beside_log;
  EventAlignment alignment;

  std::mutex mutex;
  std::vector<Parting> found;  // guarded by mutex
  std::string fault;           // written before `finished`
  std::atomic<bool> news{false}, finished{false};
  std::jthread thread;  // last: it ends first
};

Status PartingStudy::Impl::look(const std::stop_token& stop) {
  auto shown = Timeline::open(shown_log);
  if (!shown.ok()) return shown.error();
  auto opened = Timeline::open(beside_log);
  if (!opened.ok()) return opened.error();
  shown->useStop(stop);
  opened->useStop(stop);
  ScenePoseCache poses(cell);
  BesideSession beside(cell, std::move(*opened), alignment);
  const LogTime start = shown->start();
  const Nanoseconds length = shown->end() - start;
  const Nanoseconds step = std::max(kPartingStep, length / kMaxSamples + Nanoseconds(1));
  StateDamage ignored;  // pictures show where it is
  std::vector<Parting> partings;
  bool apart = false;
  for (std::int64_t i = 0; start + (i - 1) * step < shown->end(); ++i) {
    if (stop.stop_requested()) return {};
    if (i % kSamplesAtATime == 0) publish(partings);
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
  publish(std::move(partings));
  return {};
}

PartingStudy::PartingStudy(const Cell& cell, std::filesystem::path shown,
                           std::filesystem::path beside, EventAlignment alignment)
    : impl_(
          std::make_unique<Impl>(cell, std::move(shown), std::move(beside), std::move(alignment))) {
  Impl& my = *impl_;
  my.thread = std::jthread([&my](const std::stop_token& stop) {
    lowerPriority();
    if (Status looked = my.look(stop); !looked) my.fault = looked.error().text();
    my.finished = true;
    my.news = true;
    my.finished.notify_all();
  });
}

PartingStudy::~PartingStudy() = default;

std::vector<Parting> PartingStudy::found() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->found;
}

std::string PartingStudy::fault() const { return impl_->finished ? impl_->fault : std::string(); }

std::optional<LogTime> PartingStudy::beside(LogTime moment, bool after) const {
  const std::lock_guard lock(impl_->mutex);
  const std::vector<Parting>& found = impl_->found;
  const auto next = after ? std::ranges::upper_bound(found, moment, {}, &Parting::from)
                          : std::ranges::lower_bound(found, moment, {}, &Parting::from);
  if (after) return next == found.end() ? std::nullopt : std::optional(next->from);
  return next == found.begin() ? std::nullopt : std::optional(std::prev(next)->from);
}

bool PartingStudy::takeNews() const { return impl_->news.exchange(false); }
bool PartingStudy::isFinished() const { return impl_->finished; }
void PartingStudy::wait() const { impl_->finished.wait(false); }

}  // namespace rocinante
