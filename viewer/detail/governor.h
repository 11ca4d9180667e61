#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "viewer/detail/detail_level.h"

namespace rocinante {

/// Chooses the rung of detail that holds a target frame time: takes the cost of each drawn frame
/// and returns the rung of the next. Reads no clock, so that it can be tested on simulated
/// machines.
///
/// It descends as soon as frames exceed the target for longer than a hiccup, several rungs at once
/// when they exceed it by far. It ascends one rung at a time, only after the cost there, estimated
/// from the saving measured during the descent, has stayed within the target by a margin for a
/// while. So it settles when the cost depends only on the rung; with a varying load, each reverted
/// ascent doubles the wait for the next.
///
/// It guards itself against a renderer that takes leave of its senses at some view: one frame of
/// more than ten times what the last ones took, and than the target, ends its step for good.
class Governor {
 public:
  struct Settings {
    double target_ms = 1000.0 / 30;
    int coarsest = kCoarsestRung;
    /// Before the first rung there is a step with dear looks (shadows, contact), which are what is
    /// left out first.
    bool drops_looks = false;
  };

  /// A frame that ended its step.
  struct Runaway {
    double cost_ms = 0, typical_ms = 0;
    int rung = 0;             ///< that is not drawn any more, nor a finer one
    bool with_looks = false;  ///< the step with dear looks ended: rungs have not
  };

  explicit Governor(const Settings& settings) : settings_(settings) {}

  int rung() const { return settings_.drops_looks ? std::max(step_ - 1, 0) : step_; }
  /// Dear looks are drawn; false only where they may be left out.
  bool drawsLooks() const { return !settings_.drops_looks || step_ == 0; }
  /// Typical cost of the last frames on this step; 0 without frames.
  double typicalMs() const;

  /// Begins where a frame should hold the target, by the cost of one on `rung` without dear looks
  /// that was drawn to measure it. Before frameDrawn().
  void begin(int rung, double cost_ms);
  /// Begins on that rung, without dear looks where they may be left out.
  void beginAt(int rung);
  /// Takes the cost of the frame just drawn on rung(), with looks or without, and returns the rung
  /// of the next one.
  int frameDrawn(double cost_ms);

  /// The frame that ended a step since the last call, if any.
  std::optional<Runaway> takeRunaway() { return std::exchange(runaway_, std::nullopt); }
  /// Steps that ended may be tried again.
  void allowAll() { finest_ = 0; }

  /// Discards all measurements, because the user changed what is drawn (size, samples, layers) or
  /// coarser meshes became ready. Keeps the rung.
  void forget();
  /// Sets the target and calls forget().
  void setTarget(double target_ms);
  /// Sets Settings::drops_looks, keeps the rung, and calls forget().
  void setDropsLooks(bool drops);

 private:
  void moveTo(int step);
  void learnWhatWasSaved();
  bool overloaded() const;
  bool isHopeless() const;
  bool isRunaway(double cost_ms) const;
  int cheapEnoughStep() const;
  bool ascentWouldHold() const;
  int coarsestStep() const { return settings_.coarsest + (settings_.drops_looks ? 1 : 0); }
  double bestCostOf(int step) const;

  static constexpr std::size_t kSteps = kDetailRungs.size() + 1;

  Settings settings_;
  int step_ = 0;    ///< the rung, or one more where the first step is that with looks
  int finest_ = 0;  ///< no step before it is drawn
  std::optional<Runaway> runaway_;
  int skip_ = 2;               ///< frames to ignore, since first frames cost more
  std::vector<double> costs_;  ///< of the last frames on this rung, oldest first
  int calm_frames_ = 0;        ///< frames for which the next finer step would have held

  /// Cost on step i by cost on step i + 1, measured when last going from one to the other.
  std::array<std::optional<double>, kSteps> saved_{};
  /// Calm frames required before ascending to step i.
  std::array<int, kSteps> patience_ = basePatience();
  /// The previous step and its cost, until this step's cost is known.
  std::optional<double> cost_before_;
  int step_before_ = 0;
  int frames_since_ascent_ = -1;  ///< negative: none to judge

  static std::array<int, kSteps> basePatience();
};

}  // namespace rocinante
