#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/check/judges/tally.h"

namespace rocinante {

/// The usual interval of a stream: the median by time, so that half of the time lies in intervals
/// that are no longer. Packets that come in bursts thus have the interval of their bursts. To a
/// fifth; constant memory.
class UsualInterval {
 public:
  void take(Nanoseconds interval);
  /// Of all intervals together.
  double span_s() const;
  /// 0 before the first interval.
  double seconds() const;
  /// Older intervals count half from now on.
  void fade();
  void clear() { *this = {}; }

 private:
  // Four bins an octave, from a sixteenth of a millisecond to a minute.
  static constexpr std::size_t kBins = 80;
  static constexpr unsigned kFirstOctave = 16;

  std::array<std::int64_t, kBins> time_ns_{};
};

struct CadenceThresholds {
  double silence_s = 10;          ///< longest silence, or its upper bound
  bool is_silence_own = false;    ///< the cell or a rule sets it; else it follows from the rate
  bool is_silence_given = false;  ///< by the cell for this source: judged at any rate
  std::optional<std::pair<double, double>> rate_hz;
  std::optional<double> jitter_s;
};

/// Judges when the packets of one source arrive: how often, how evenly, and whether at all.
///
/// A silence is longer than kSilencePeriods of the source's own periods (the slowest that the cell
/// expects, else the usual one so far), within kLeastSilence_s and `silence_s`. A source may only
/// restate while nothing moves: then it is a silence after kIdle_s.
class CadenceJudge {
 public:
  explicit CadenceJudge(const CadenceThresholds& thresholds) : thresholds_(thresholds) {}

  /// The next packet of the source that is not a restatement. `lost`: how many before it never
  /// arrived.
  void take(const PacketPlace& place, std::uint64_t lost);
  /// A restatement: does not count for the rate, but shows that the source is alive.
  void takeRestatement(const PacketPlace& place);

  /// `end`: of the session.
  void report(const std::string& source, LogTime end, Findings& findings) const;
  /// Forgets what was found; counts of uneven packets fade by half. The rhythm is followed on.
  void dropFindings();

 private:
  void begin(const PacketPlace& place);
  void judgeSilence(const PacketPlace& place, bool is_restatement);
  /// The longest time without a packet that is not a silence.
  double silenceLimit() const;
  /// The same where restatements may be all that it sends.
  double idleLimit() const;
  void judgeRate(const PacketPlace& place, std::uint64_t sent, double interval_s);
  void judgeJitter(const PacketPlace& place, double interval_s, std::uint64_t sent, bool is_pause);
  /// Whether a silence of this source is a fault: it sent often until then.
  bool isExpected() const;

  CadenceThresholds thresholds_;
  bool is_begun_ = false;
  std::uint32_t stretch_ = 0;
  LogTime began_{}, last_{}, last_sign_{};
  bool was_restatement_ = false;                 ///< the last sign
  std::uint64_t packets_ = 0, all_packets_ = 0;  ///< of this run, and of all runs
  PacketPlace last_place_;

  LogTime window_began_{};
  std::uint64_t window_sent_ = 0;
  bool window_has_pause_ = false, was_long_ = false;
  Tally rate_;
  double worst_rate_hz_ = 0, worst_rate_off_ = 0;

  double period_s_ = 0;  ///< a running mean
  std::uint64_t intervals_ = 0;
  Tally uneven_;
  double worst_uneven_s_ = 0;

  UsualInterval usual_;
  bool is_steady_ = true;  ///< it never restated twice with nothing in between
  bool was_pause_ = false;
  struct Silences {
    Tally tally;
    double longest_s = 0, limit_s = 0;
    void hit(const PacketPlace& place, LogTime since, double limit_s);
  };
  Silences silences_, idle_silences_;  ///< by silenceLimit(); by idleLimit()
};

}  // namespace rocinante
