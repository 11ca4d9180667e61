#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/check/judges/tally.h"

namespace rocinante {

struct ClockThresholds {
  double skew_s = 1;
  double drift_ppm = 200;
  double step_s = 0.5;
};

/// Compares a source's TIME with the arrival of its packets. Networks and schedulers only delay
/// packets: the least delayed ones show the clock.
class ClockJudge {
 public:
  explicit ClockJudge(const ClockThresholds& thresholds) : thresholds_(thresholds) {}

  /// The next packet that has a TIME, in order.
  void take(const PacketPlace& place);
  /// The source is a replay: its TIME no longer shows a clock.
  void ignore() { is_ignored_ = true; }

  void report(const std::string& source, Findings& findings) const;
  /// Forgets what was found, and delays of more than kKeptSpan ago.
  void dropFindings();

 private:
  static constexpr std::size_t kBins = 64;
  /// Long enough for the least drift that is reported.
  static constexpr Nanoseconds kKeptSpan = std::chrono::minutes(5);

  void begin(const PacketPlace& place, std::int64_t delay_ns);
  void noteDelay(const PacketPlace& place, std::int64_t delay_ns);
  bool steps(const PacketPlace& place, std::int64_t delay_ns);
  void reportDrift(const std::string& source, Findings& findings) const;

  ClockThresholds thresholds_;
  bool is_ignored_ = false, is_begun_ = false, is_wall_ = false;
  std::uint32_t stretch_ = 0;
  std::int64_t last_sent_ns_ = 0;
  /// Since the clock was last set: arrival less TIME.
  LogTime began_{}, last_{}, least_at_{};
  std::uint64_t count_ = 0;
  std::int64_t least_ns_ = 0;
  /// The least delay of each interval; intervals double as the session grows.
  struct Least {
    std::int64_t at_ns = 0, delay_ns = 0;
    bool is_set = false;
  };
  std::array<Least, kBins> bins_{};
  std::int64_t bin_ns_ = std::int64_t{1} << 27;
  /// Before it was first set.
  std::optional<std::int64_t> first_least_ns_;
  PacketPlace first_place_;
  std::string first_example_;
  Tally steps_;
  double worst_step_s_ = 0;
};

}  // namespace rocinante
