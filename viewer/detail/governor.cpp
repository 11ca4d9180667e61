#include "viewer/detail/governor.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

/// Smallest and largest number of frames in a median.
constexpr std::size_t kEnoughFrames = 5;
constexpr std::size_t kWindow = 9;
/// Three frames in a row that exceed the target by this factor are not a hiccup.
constexpr double kFarTooDear = 2;
constexpr std::size_t kFewFrames = 3;
/// One that exceeds it by this factor is enough, where none before it was cheaper.
constexpr double kHopeless = 8;
/// A frame by what the last ones took, or by the target.
constexpr double kRunaway = 10;
/// Estimated cost of the next finer rung must be below this share of the target.
constexpr double kMargin = 0.85;
constexpr int kBasePatience = 45;
constexpr int kLongestPatience = 1 << 20;
/// Of a frame with dear looks, by one of rung 0 without them, at most (docs/rendering.md, "Looks").
constexpr double kBestCostWithLooks = 5;
/// An ascent that lasted this many times its patience was right.
constexpr int kHeldFor = 16;

double medianOf(std::vector<double> costs) {
  const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::nth_element(costs.begin(), middle, costs.end());
  return *middle;
}

}  // namespace

std::array<int, Governor::kSteps> Governor::basePatience() {
  std::array<int, kSteps> patience{};
  patience.fill(kBasePatience);
  return patience;
}

double Governor::typicalMs() const { return costs_.empty() ? 0 : medianOf(costs_); }

bool Governor::overloaded() const {
  if (costs_.size() >= kFewFrames && *std::min_element(costs_.end() - kFewFrames, costs_.end()) >
                                         kFarTooDear * settings_.target_ms) {
    return true;
  }
  return costs_.size() >= kWindow && typicalMs() > settings_.target_ms;
}

void Governor::begin(int rung, double cost_ms) {
  const int measured = rung + (settings_.drops_looks ? 1 : 0);
  // The geometric mean of no saving and the largest possible, as for an ascent.
  const auto expected = [&](int step) {
    return cost_ms * std::sqrt(bestCostOf(step) / bestCostOf(measured));
  };
  int step = finest_;
  while (step < coarsestStep() && expected(step) > kMargin * settings_.target_ms) ++step;
  step_ = step;
  forget();
}

void Governor::beginAt(int rung) {
  step_ = std::max(rung + (settings_.drops_looks ? 1 : 0), finest_);
  forget();
}

double Governor::bestCostOf(int step) const {
  if (!settings_.drops_looks) return kDetailRungs[static_cast<std::size_t>(step)].best_cost;
  return step == 0 ? kBestCostWithLooks
                   : kDetailRungs[static_cast<std::size_t>(step - 1)].best_cost;
}

/// No hiccup explains it, and nobody waits for more of them to know.
bool Governor::isHopeless() const {
  if (costs_.empty() || costs_.size() >= kFewFrames) return false;
  return *std::min_element(costs_.begin(), costs_.end()) > kHopeless * settings_.target_ms;
}

int Governor::cheapEnoughStep() const {
  // Use the last few frames only: cheap frames before a new load must not count.
  const auto few = static_cast<std::ptrdiff_t>(std::min(kFewFrames, costs_.size()));
  const double now = medianOf({costs_.end() - few, costs_.end()});
  const double here = bestCostOf(step_);
  int step = step_ + 1;
  while (step < coarsestStep() && now * bestCostOf(step) / here > settings_.target_ms) ++step;
  return step;
}

bool Governor::isRunaway(double cost_ms) const {
  return step_ < coarsestStep() && costs_.size() >= kFewFrames &&
         cost_ms > kRunaway * std::max(typicalMs(), settings_.target_ms);
}

bool Governor::ascentWouldHold() const {
  if (step_ <= finest_ || costs_.size() < kEnoughFrames) return false;
  const auto finer = static_cast<std::size_t>(step_ - 1);
  // Unknown saving: assume the geometric mean of none and the largest possible. The attempt
  // measures the real value.
  const double saved = saved_[finer].value_or(std::sqrt(bestCostOf(step_ - 1) / bestCostOf(step_)));
  return typicalMs() * saved <= kMargin * settings_.target_ms;
}

void Governor::learnWhatWasSaved() {
  if (!cost_before_ || (costs_.size() < kFewFrames && !isHopeless())) return;
  const double here = typicalMs();
  if (step_ == step_before_ + 1 && here > 0) {
    saved_[static_cast<std::size_t>(step_before_)] = *cost_before_ / here;
  } else if (step_ == step_before_ - 1 && *cost_before_ > 0) {
    saved_[static_cast<std::size_t>(step_)] = here / *cost_before_;
  }
  if (costs_.size() >= kEnoughFrames) cost_before_.reset();
}

void Governor::moveTo(int step) {
  if (step > step_ && frames_since_ascent_ >= 0) {
    // The ascent had to be reverted.
    int& patience = patience_[static_cast<std::size_t>(step_)];
    patience = std::min(patience * 2, kLongestPatience);
  }
  frames_since_ascent_ = step < step_ ? 0 : -1;
  cost_before_ = typicalMs();
  step_before_ = step_;
  step_ = step;
  costs_.clear();
  calm_frames_ = 0;
  skip_ = 1;
}

int Governor::frameDrawn(double cost_ms) {
  if (skip_ > 0) {
    --skip_;
    return rung();
  }
  if (isRunaway(cost_ms)) {
    runaway_ = Runaway{cost_ms, typicalMs(), rung(), settings_.drops_looks && step_ == 0};
    finest_ = step_ + 1;
    moveTo(finest_);
    return rung();
  }
  if (costs_.size() == kWindow) costs_.erase(costs_.begin());
  costs_.push_back(std::isfinite(cost_ms) ? std::max(cost_ms, 0.0) : 0.0);
  learnWhatWasSaved();
  if (frames_since_ascent_ >= 0) {
    int& patience = patience_[static_cast<std::size_t>(step_)];
    if (++frames_since_ascent_ > kHeldFor * std::min(patience, kLongestPatience / kHeldFor)) {
      patience = kBasePatience;
      frames_since_ascent_ = -1;
    }
  }
  if (step_ < coarsestStep() && (overloaded() || isHopeless())) {
    moveTo(cheapEnoughStep());
    return rung();
  }
  calm_frames_ = ascentWouldHold() ? calm_frames_ + 1 : 0;
  if (calm_frames_ > 0 && calm_frames_ >= patience_[static_cast<std::size_t>(step_ - 1)]) {
    moveTo(step_ - 1);
  }
  return rung();
}

void Governor::forget() {
  const int step = step_, finest = finest_;
  const auto runaway = runaway_;
  *this = Governor(settings_);
  step_ = step;
  finest_ = finest;
  runaway_ = runaway;
  skip_ = 1;
}

void Governor::setDropsLooks(bool drops) {
  const int rung_now = rung();
  if (drops != settings_.drops_looks && finest_ > 0) finest_ += drops ? 1 : -1;
  settings_.drops_looks = drops;
  step_ = drops && rung_now > 0 ? rung_now + 1 : rung_now;
  forget();
}

void Governor::setTarget(double target_ms) {
  settings_.target_ms = target_ms;
  forget();
}

}  // namespace rocinante
