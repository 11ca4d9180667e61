#include "viewer/ui/study/moment_study.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/cell/scene_pose_cache.h"
#include "core/session/timeline.h"
#include "viewer/ui/study/study_thread.h"

namespace rocinante {

struct MomentStudy::Impl {
  Impl(const Cell& cell, std::function<void()> ready) : on_ready(std::move(ready)), poses(cell) {}

  void work(const std::stop_token& stop);
  void look(const std::stop_token& stop);

  std::function<void()> on_ready;

  // Of the thread while busy, else of the caller.
  ScenePoseCache poses;
  std::filesystem::path log, opened;
  LogTime moment{};
  std::optional<Timeline> timeline;  // of `opened`; the scene borrows from its state
  std::optional<PosedScene> scene;

  mutable std::mutex mutex;
  mutable std::condition_variable_any changed;
  bool busy = false;    // guarded by mutex
  std::jthread thread;  // last: it ends first
};

void MomentStudy::Impl::look(const std::stop_token& stop) {
  scene.reset();
  // A log that grows is opened again for what was not there yet.
  if (!timeline || opened != log || moment > timeline->end()) {
    timeline.reset();
    auto now = Timeline::open(log);
    if (!now.ok()) return;
    timeline = std::move(*now);
    timeline->useStop(stop);
    opened = log;
  }
  const auto state = timeline->stateAt(moment);
  if (state.ok()) scene = poses.pose(**state);
}

void MomentStudy::Impl::work(const std::stop_token& stop) {
  lowerPriority();
  while (true) {
    {
      std::unique_lock lock(mutex);
      if (!changed.wait(lock, stop, [this] { return busy; })) return;
    }
    look(stop);
    {
      const std::lock_guard lock(mutex);
      busy = false;
    }
    changed.notify_all();
    on_ready();
  }
}

MomentStudy::MomentStudy(const Cell& cell, std::function<void()> on_ready)
    : impl_(std::make_unique<Impl>(cell, std::move(on_ready))) {
  Impl& my = *impl_;
  my.thread = std::jthread([&my](const std::stop_token& stop) { my.work(stop); });
}

MomentStudy::~MomentStudy() = default;

bool MomentStudy::busy() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->busy;
}

void MomentStudy::ask(std::filesystem::path log, LogTime moment) {
  impl_->log = std::move(log);
  impl_->moment = moment;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->busy = true;
  }
  impl_->changed.notify_all();
}

const PosedScene* MomentStudy::scene() const {
  return busy() || !impl_->scene ? nullptr : &*impl_->scene;
}

void MomentStudy::wait() const {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [this] { return !impl_->busy; });
}

}  // namespace rocinante
