#include "viewer/ui/study/nearest_study.h"

#include <fmt/format.h>

#include <limits>

#include "core/base/plain_text.h"
#include "core/clearance/clearance_gauge.h"

namespace rocinante {
namespace {

std::string nameOf(const std::string& device, const std::string& link) {
  return link.empty() ? device : device + "/" + link;
}

/// A pattern of that name alone, which might hold those of patterns, or begin as a layer's.
std::string exactly(const std::string& name) {
  std::string pattern;
  for (const char byte : name) {
    pattern += '\\';
    pattern += byte;
  }
  return pattern;
}

}  // namespace

std::string nearestText(const NearestFound& found) {
  const double mm = roundedClearance(found.distance_m) * 1e3;
  const std::string from = nameOf(found.other, found.wish.other_link);
  const std::string how = (mm > 0 ? fmt::format("{:.2f} mm from ", mm) : "touches ") + from;
  if (found.wish.link.empty()) return plainText(how);
  return plainText(nameOf(found.wish.device, found.wish.link) + ": " + how);
}

/// Only the worker thread touches it.
class NearestStudy::Gauge {
 public:
  explicit Gauge(const Cell& cell) : cell_(cell) {}
  NearestFound answer(const Question& question);

 private:
  void measureFor(const NearestQuery& wish);

  Cell cell_;              // a copy whose clearances are the wish; models are shared
  NearestQuery measured_;  // the last wish
  std::optional<ClearanceGauge> gauge_;
};

void NearestStudy::Gauge::measureFor(const NearestQuery& wish) {
  if (gauge_ && measured_ == wish) return;
  measured_ = wish;
  gauge_.reset();
  CellClearance apart;
  apart.name = "nearest";
  apart.between = {exactly(nameOf(wish.device, wish.link)),
                   wish.other.empty() ? "*" : exactly(nameOf(wish.other, wish.other_link))};
  apart.is_self = wish.other == wish.device;
  cell_.clearances = {apart};
  gauge_.emplace(cell_);
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
