#pragma once

#include <array>
#include <cstddef>

namespace rocinante {

/// Cost of one frame of the window, milliseconds of wall time by stage.
struct FrameTimes {
  double app = 0;   ///< state, poses, content of the frame
  double cull = 0;  ///< visible items in drawing order
  double draw = 0;  ///< until the driver has drawn it
  double ui = 0;    ///< the panels
  double total() const { return app + cull + draw + ui; }
};

/// The last frames, for a small graph and readable figures. Plain values.
class FrameHistory {
 public:
  static constexpr std::size_t kFrames = 120;

  void add(const FrameTimes& times) {
    frames_[next_] = times;
    next_ = (next_ + 1) % kFrames;
    if (count_ < kFrames) ++count_;
    const double weight = count_ < 10 ? 1.0 / static_cast<double>(count_) : 0.1;
    const auto follow = [weight](double& mean, double value) { mean += (value - mean) * weight; };
    follow(mean_.app, times.app);
    follow(mean_.cull, times.cull);
    follow(mean_.draw, times.draw);
    follow(mean_.ui, times.ui);
  }

  std::size_t count() const { return count_; }
  /// 0 is the oldest kept frame.
  const FrameTimes& operator[](std::size_t i) const {
    return frames_[(next_ + kFrames - count_ + i) % kFrames];
  }
  /// Smoothed for readability.
  const FrameTimes& mean() const { return mean_; }

 private:
  std::array<FrameTimes, kFrames> frames_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  FrameTimes mean_;
};

}  // namespace rocinante
