#include "viewer/ui/study/nearest_study.h"

#include <limits>
#include <utility>

#include "core/clearance/clearance_gauge.h"

namespace rocinante {

/// Only the worker thread touches it.
class NearestStudy::Gauge {
 public:
  explicit Gauge(const Cell& cell) : cell_(cell) {}
  NearestFound answer(const Question& question);

 private:
  void measureFor(const NearestQuery& wish);

  Cell cell_;  // a copy whose clearances are the wish; models are shared
  // Of the last wish. A device's own patterns would be read as patterns: `chosen` is exact.
  NearestQuery measured_;
  std::optional<ClearanceGauge> gauge_;
};

void NearestStudy::Gauge::measureFor(const NearestQuery& wish) {
  if (gauge_ && measured_ == wish) return;
  measured_ = wish;
  gauge_.reset();
  CellClearance apart;
  apart.name = "nearest";
  apart.between = {wish.device, wish.other.empty() ? "*" : wish.other};
  cell_.clearances = {apart};
  gauge_.emplace(cell_, [wish](std::string_view a, std::string_view b) {
    if (a != wish.device) std::swap(a, b);
    return a == wish.device && a != b && (wish.other.empty() || b == wish.other);
  });
}

NearestFound NearestStudy::Gauge::answer(const Question& asked) {
  measureFor(asked.wish);
  NearestFound answer{asked.wish, asked.moment, {}, 0, {}, {}};
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> distances;
  gauge_->measure(asked.state, distances);
  const std::vector<ClearanceGap> gaps = gauge_->gaps();
  const std::vector<GapPlace> places = gauge_->places(asked.state);
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

NearestStudy::NearestStudy(const Cell& cell)
    : worker_([gauge = Gauge(cell)](const Question& question, const std::stop_token&) mutable {
        return gauge.answer(question);
      }) {}

bool NearestStudy::ask(const NearestQuery& wish, const SessionState& state, LogTime moment) {
  if (worker_.isBusy()) return false;
  worker_.ask({wish, state, moment});
  return true;
}

std::optional<NearestFound> NearestStudy::found() const {
  const auto found = worker_.found();
  return found ? std::optional(*found) : std::nullopt;
}

}  // namespace rocinante
