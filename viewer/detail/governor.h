#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "viewer/detail/detail_level.h"

namespace rocinante {

/// Chooses the rung of detail that holds a target frame time: the cost of each frame drawn goes in,
/// the rung of the next one comes out. Pure: reads no clock, so that it can be tried on simulated
/// machines.
///
/// It goes down as soon as frames are too dear for longer than a hiccup, several rungs at once when
/// they are far too dear. It goes up one rung at a time, and only when the cost there, reckoned
/// from what going down saved when it did, has stayed within the target by a margin for a while. So
/// where a machine's cost depends on the rung alone, it comes to rest; and where the load itself
/// comes and goes, each ascent that had to be taken back doubles the wait for the next.
class Governor {
 public:
  struct Settings {
    double target_ms = 1000.0 / 30;
    int coarsest = kCoarsestRung;
  };

  explicit Governor(const Settings& settings) : settings_(settings) {}

  int rung() const { return rung_; }
  /// Typical cost of the last frames on this rung; 0 before there are any.
  double typicalMs() const;

  /// The frame just drawn on rung() cost so much. Answers the rung of the next one.
  int frameDrawn(double cost_ms);

  /// What was learnt counts no more, because the person changed what is drawn (size, samples,
  /// layers) or more can be saved now (coarser meshes are ready). The rung stays.
  void forget();
  /// Another target, and forget().
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
  int skip_ = 2;               ///< frames still to be ignored: they pay for being the first
  std::vector<double> costs_;  ///< of the last frames on this rung, oldest first
  int calm_frames_ = 0;        ///< for so many the next finer rung would have held

  /// Cost on rung i by cost on rung i + 1, measured when last going from one to the other.
  std::array<std::optional<double>, kRungs> saved_{};
  /// Calm frames wanted before rung i is entered from below.
  std::array<int, kRungs> patience_ = basePatience();
  /// Where we came from, and what frames cost there, until this rung's own cost is known.
  std::optional<double> cost_before_;
  int rung_before_ = 0;
  int frames_since_ascent_ = -1;  ///< negative: none to judge

  static std::array<int, kRungs> basePatience();
};

}  // namespace rocinante
