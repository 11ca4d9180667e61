#pragma once

#include <array>
#include <cstddef>
#include <optional>
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
class Governor {
 public:
  struct Settings {
    double target_ms = 1000.0 / 30;
    int coarsest = kCoarsestRung;
  };

  explicit Governor(const Settings& settings) : settings_(settings) {}

  int rung() const { return rung_; }
  /// Typical cost of the last frames on this rung; 0 without frames.
  double typicalMs() const;

  /// Takes the cost of the frame just drawn on rung() and returns the rung of the next one.
  int frameDrawn(double cost_ms);

  /// Discards all measurements, because the user changed what is drawn (size, samples, layers) or
  /// coarser meshes became ready. Keeps the rung.
  void forget();
  /// Sets the target and calls forget().
  void setTarget(double target_ms);

 private:
  void moveTo(int rung);
  void learnWhatWasSaved();
  bool overloaded() const;
  int cheapEnoughRung() const;
  bool ascentWouldHold() const;

  static constexpr std::size_t kRungs = kDetailRungs.size();

  Settings settings_;
  int rung_ = 0;
  int skip_ = 2;               ///< frames to ignore, since first frames cost more
  std::vector<double> costs_;  ///< of the last frames on this rung, oldest first
  int calm_frames_ = 0;        ///< frames for which the next finer rung would have held

  /// Cost on rung i by cost on rung i + 1, measured when last going from one to the other.
  std::array<std::optional<double>, kRungs> saved_{};
  /// Calm frames required before ascending to rung i.
  std::array<int, kRungs> patience_ = basePatience();
  /// The previous rung and its cost, until this rung's cost is known.
  std::optional<double> cost_before_;
  int rung_before_ = 0;
  int frames_since_ascent_ = -1;  ///< negative: none to judge

  static std::array<int, kRungs> basePatience();
};

}  // namespace rocinante
