#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// How the times of two sessions are matched (docs/golden-suites.md, "Runs").
enum class RunAlign : std::uint8_t {
  origin,  ///< from each session's first datagram
  events,  ///< piecewise between common events
  warp,    ///< and within a bound between them, by motion
};
std::string_view nameOf(RunAlign align);
std::optional<RunAlign> runAlignNamed(std::string_view name);

/// How far a run may leave the band of the accepted ones.
struct RunLimits {
  double joint_deg = 0.05;   ///< joint angles
  double position_mm = 0.5;  ///< positions of links and drawings, joints that slide
  double turn_deg = 0.05;    ///< orientations of links
  /// The stated poses of devices, where `pose_mm` and `pose_deg` are written; else as the two
  /// above.
  std::optional<double> pose_mm{}, pose_deg{};
  /// Numbers of signals: in their unit, where it is written; else a share of the range that they
  /// have in the accepted sessions, and what their noise spans.
  std::optional<double> signal{};
  double signal_share = 0.1;
  double event_ms = 20;  ///< events, and how much earlier or later a value may come
  /// `position_mm` and `turn_deg` are written: links are judged by them.
  bool link_positions = false, link_turns = false;

  double ofPose_mm() const { return pose_mm.value_or(position_mm); }
  double ofPose_deg() const { return pose_deg.value_or(turn_deg); }
};
/// No limit may be smaller, those of signals excepted: recordings of one motion differ by so much.
inline constexpr RunLimits kRunFloors{};

/// Limits of a device or an item; empty ones are the run's.
struct OwnLimits {
  std::optional<double> joint_deg, position_mm, turn_deg, pose_mm, pose_deg, event_ms, signal,
      signal_share;
};

/// What is not judged.
struct RunMask {
  std::string item = "*";  ///< a pattern of RunFinding::item; a device covers everything of it
  Nanoseconds from = Nanoseconds::min(), until = Nanoseconds::max();  ///< since the accepted origin
};

/// The device that an item is about: "arm" of "arm/elbow" and of "signal arm/tool0 force"; "-" of a
/// signal of none.
std::string deviceOfItem(std::string_view item);

/// "arm/wrist from 2 s until 4 s".
std::string maskText(const RunMask& mask);

/// What to compare, and how closely.
struct RunSpec {
  RunAlign align = RunAlign::events;
  Nanoseconds warp{std::chrono::milliseconds(200)};  ///< for RunAlign::warp
  RunLimits limits;
  std::map<std::string, OwnLimits, std::less<>>
      own_limits;  ///< by DEVICE, DEVICE/JOINT or "signal PATH NAME"
  std::vector<RunMask> masks;

  /// Of an item "DEVICE/PART" or "signal PATH NAME": its own, else its device's, else the run's.
  RunLimits limitsOf(std::string_view item) const;
  bool isMasked(std::string_view item, Nanoseconds since_origin) const;
  /// For the whole session.
  bool isMaskedThroughout(std::string_view item) const;
};

}  // namespace rocinante
