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
/// Estimated cost of the next finer rung must be below this share of the target.
constexpr double kMargin = 0.85;
constexpr int kBasePatience = 45;
constexpr int kLongestPatience = 1 << 20;
/// An ascent that lasted this many times its patience was right.
constexpr int kHeldFor = 16;

double medianOf(std::vector<double> costs) {
  const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::nth_element(costs.begin(), middle, costs.end());
  return *middle;
}

}  // namespace

std::array<int, Governor::kRungs> Governor::basePatience() {
  std::array<int, kRungs> patience{};
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

int Governor::cheapEnoughRung() const {
  // Use the last few frames only: cheap frames before a new load must not count.
  const double now = medianOf({costs_.end() - kFewFrames, costs_.end()});
  const double here = kDetailRungs[static_cast<std::size_t>(rung_)].best_cost;
  int rung = rung_ + 1;
  while (rung < settings_.coarsest &&
         now * kDetailRungs[static_cast<std::size_t>(rung)].best_cost / here >
             settings_.target_ms) {
    ++rung;
  }
  return rung;
}

bool Governor::ascentWouldHold() const {
  if (rung_ == 0 || costs_.size() < kEnoughFrames) return false;
  const auto finer = static_cast<std::size_t>(rung_ - 1);
  // Unknown saving: assume the geometric mean of none and the largest possible. The attempt
  // measures the real value.
  const double saved = saved_[finer].value_or(
      std::sqrt(kDetailRungs[finer].best_cost / kDetailRungs[finer + 1].best_cost));
  return typicalMs() * saved <= kMargin * settings_.target_ms;
}

void Governor::learnWhatWasSaved() {
  if (!cost_before_ || costs_.size() < kFewFrames) return;
  const double here = typicalMs();
  if (rung_ == rung_before_ + 1 && here > 0) {
    saved_[static_cast<std::size_t>(rung_before_)] = *cost_before_ / here;
  } else if (rung_ == rung_before_ - 1 && *cost_before_ > 0) {
    saved_[static_cast<std::size_t>(rung_)] = here / *cost_before_;
  }
  if (costs_.size() >= kEnoughFrames) cost_before_.reset();
}

void Governor::moveTo(int rung) {
  if (rung > rung_ && frames_since_ascent_ >= 0) {
    // The ascent had to be reverted.
    int& patience = patience_[static_cast<std::size_t>(rung_)];
    patience = std::min(patience * 2, kLongestPatience);
  }
  frames_since_ascent_ = rung < rung_ ? 0 : -1;
  cost_before_ = typicalMs();
  rung_before_ = rung_;
  rung_ = rung;
  costs_.clear();
  calm_frames_ = 0;
  skip_ = 1;
}

int Governor::frameDrawn(double cost_ms) {
  if (skip_ > 0) {
    --skip_;
    return rung_;
  }
  if (costs_.size() == kWindow) costs_.erase(costs_.begin());
  costs_.push_back(std::isfinite(cost_ms) ? std::max(cost_ms, 0.0) : 0.0);
  learnWhatWasSaved();
  if (frames_since_ascent_ >= 0) {
    int& patience = patience_[static_cast<std::size_t>(rung_)];
    if (++frames_since_ascent_ > kHeldFor * std::min(patience, kLongestPatience / kHeldFor)) {
      patience = kBasePatience;
      frames_since_ascent_ = -1;
    }
  }
  if (rung_ < settings_.coarsest && overloaded()) {
    moveTo(cheapEnoughRung());
    return rung_;
  }
  calm_frames_ = ascentWouldHold() ? calm_frames_ + 1 : 0;
  if (calm_frames_ > 0 && calm_frames_ >= patience_[static_cast<std::size_t>(rung_ - 1)]) {
    moveTo(rung_ - 1);
  }
  return rung_;
}

void Governor::forget() {
  const int rung = rung_;
  *this = Governor(settings_);
  rung_ = rung;
  skip_ = 1;
}

void Governor::setTarget(double target_ms) {
  settings_.target_ms = target_ms;
  forget();
}

}  // namespace rocinante
