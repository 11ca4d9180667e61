#include "viewer/ui/study/nearest_study.h"

#include <algorithm>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include "core/clearance/clearance_gauge.h"
#include "viewer/ui/study/study_thread.h"

namespace rocinante {

struct NearestStudy::Impl {
  explicit Impl(const Cell& the_cell) : cell(the_cell) {}

  struct Question {
    NearestWish wish;
    SessionState state;
    LogTime moment;
  };

  NearestFound answer(const Question& question);
  void work(const std::stop_token& stop);
  void measureFor(const NearestWish& wish);

  Cell cell;  // a copy whose clearances are the wish; models are shared
  // Of the last wish. A device's own patterns would be read as patterns: `chosen` is exact.
  NearestWish measured;
  std::optional<ClearanceGauge> gauge;

  mutable std::mutex mutex;
  mutable std::condition_variable_any changed;
  std::optional<Question> question;   // guarded by mutex; there is one while it is worked on
  std::optional<NearestFound> found;  // guarded by mutex
  bool news = false;                  // guarded by mutex
  std::jthread thread;                // last: it ends first
};

void NearestStudy::Impl::measureFor(const NearestWish& wish) {
  if (gauge && measured == wish) return;
  measured = wish;
  gauge.reset();
  CellClearance apart;
  apart.name = "nearest";
  apart.between = {wish.device, wish.other.empty() ? "*" : wish.other};
  cell.clearances = {apart};
  gauge.emplace(cell, [wish](std::string_view a, std::string_view b) {
    if (a != wish.device) std::swap(a, b);
    return a == wish.device && a != b && (wish.other.empty() || b == wish.other);
  });
}

NearestFound NearestStudy::Impl::answer(const Question& asked) {
  measureFor(asked.wish);
  NearestFound answer{asked.wish, asked.moment, {}, 0, {}, {}};
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> distances;
  gauge->measure(asked.state, distances);
  const std::vector<ClearanceGap> gaps = gauge->gaps();
  const std::vector<GapPlace> places = gauge->places(asked.state);
  // places() leaves out what is not there, for which measure() has NaN.
  std::size_t place = 0;
  for (std::size_t i = 0; i < gaps.size() && i < distances.size(); ++i) {
    if (distances[i] != distances[i]) continue;
    const GapPlace& at = places[place++];
    if (!(at.distance_m < least)) continue;
    least = at.distance_m;
    const bool is_first = gaps[i].device_a == asked.wish.device;
    answer.other = is_first ? gaps[i].device_b : gaps[i].device_a;
    answer.distance_m = at.distance_m;
    answer.on_device = is_first ? at.on_a : at.on_b;
    answer.on_other = is_first ? at.on_b : at.on_a;
  }
  return answer;
}

void NearestStudy::Impl::work(const std::stop_token& stop) {
  lowerPriority();
  std::unique_lock lock(mutex);
  while (changed.wait(lock, stop, [this] { return question.has_value(); })) {
    const Question& asked = *question;
    lock.unlock();
    NearestFound answered = answer(asked);
    lock.lock();
    found = std::move(answered);
    question.reset();
    news = true;
    changed.notify_all();
  }
}

NearestStudy::NearestStudy(const Cell& cell) : impl_(std::make_unique<Impl>(cell)) {
  impl_->thread = std::jthread([this](const std::stop_token& stop) { impl_->work(stop); });
}

NearestStudy::~NearestStudy() = default;

bool NearestStudy::ask(const NearestWish& wish, const SessionState& state, LogTime moment) {
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->question) return false;
    impl_->question.emplace(Impl::Question{wish, state, moment});
  }
  impl_->changed.notify_all();
  return true;
}

std::optional<NearestFound> NearestStudy::found() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->found;
}

bool NearestStudy::isBusy() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->question.has_value();
}

bool NearestStudy::takeNews() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->news, false);
}

void NearestStudy::wait() const {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [this] { return !impl_->question.has_value(); });
}

}  // namespace rocinante
