#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/base/late_histogram.h"
#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/report/account.h"
#include "player/send/paced_sender.h"

namespace rocinante {

/// One played span, and what was sent of it.
struct PlayedSpanReport {
  LogTime from{};
  LogTime until{};
  std::uint64_t sent = 0;
  std::string sha256;  ///< of the payloads in order; lower-case hexadecimal
};

/// What a player or a source sent, and how well it kept its schedule (docs/programs/play.md). The
/// sender's own restatements count in `restatements` only.
struct PlayReport {
  std::vector<std::string> inputs;  ///< the logs, or the file, or "demo"
  std::string source;               ///< SOURCE and RUN; set by a source only
  std::string run;
  std::string to;
  std::optional<PlaybackSpeed> speed;  ///< empty: without a schedule
  std::uint64_t sent = 0;
  std::uint64_t bytes = 0;
  std::uint64_t restatements = 0;
  std::uint64_t late_p50_us = 0, late_p90_us = 0, late_p99_us = 0, late_p999_us = 0;
  std::uint64_t late_max_us = 0;
  std::vector<LateHistogram::Bin> late_bins;
  Nanoseconds drift{};
  Nanoseconds duration{};  ///< from the first datagram to the last
  std::string stream_sha256;
  std::vector<PlayedSpanReport> spans;
  std::string timing_source;        ///< "kernel", "clock" or "kernel and clock"
  std::string scheduling;           ///< "fifo" or "other"
  bool interrupted = false;         ///< ended by a signal or a quit command
  std::vector<std::string> damage;  ///< unreadable parts of the logs
  Account left_out;                 ///< datagrams that the network cannot carry
  /// The failure that ended it early: the network, the logs, or a missing acknowledgement.
  std::optional<Error> failure;

  double achievedRateHz() const;
  /// False when sending fell behind its schedule and stayed there.
  bool keptUp() const { return drift < std::chrono::milliseconds(50); }
};

/// The report as JSON, with a line end. `format` comes first.
std::string jsonText(const PlayReport& report);
/// The report in a few lines for the user.
std::string summaryText(const PlayReport& report);
/// The warning when sending did not keep up.
std::string behindText(const PlayReport& report);

/// Counts, hashes and times sent datagrams. Memory does not grow with their number.
class PlayJournal final : public SendJournal {
 public:
  /// `from` and `until` are the span of streams that do not give bounds.
  PlayJournal(LogTime from, LogTime until) : bounds_{from, until} {}

  void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) override;
  void tooLong(const Due& due) override;

  /// Fills in what the journal knows. Call once, at the end; `whole` if the last span was played to
  /// its end.
  void writeTo(PlayReport& report, bool whole = true);

 private:
  void closeSpan(bool whole);

  PlayedSpan bounds_;        ///< of the span being played
  LogTime last_sent_{};      ///< log time of its last message
  bool has_bounds_ = false;  ///< the stream gives bounds
  Account left_out_;
  Sha256 stream_hash_;
  Sha256 span_hash_;
  std::uint32_t span_ = 0;
  std::uint64_t span_sent_ = 0;
  std::vector<PlayedSpanReport> spans_;
  std::uint64_t sent_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t restatements_ = 0;
  LateHistogram late_;
  DriftMeter drift_;
  SteadyTime first_{}, last_{};
};

}  // namespace rocinante
