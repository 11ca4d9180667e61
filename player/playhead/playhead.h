#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "player/logs/multi_log_reader.h"
#include "player/logs/play_routes.h"
#include "player/logs/read_ahead.h"
#include "player/logs/restated_block.h"
#include "player/logs/tape_finder.h"
#include "player/logs/tape_stream.h"
#include "player/playhead/playhead_command.h"
#include "player/send/datagram_stream.h"
#include "player/send/playback_clock.h"

namespace rocinante {

struct PlayheadOptions {
  PlayedSpan span;                 ///< what there is to be played
  std::optional<LogTime> start;    ///< where to begin; empty: with the span
  std::uint32_t turns = 1;         ///< of the whole span; 0: endless
  std::optional<PlayedSpan> loop;  ///< played endlessly once it is reached; within `span`
  LogTime origin{}, end{};         ///< that times in commands and answers count from
  std::optional<PlaybackSpeed> speed = PlaybackSpeed();  ///< empty: without a schedule
  bool start_paused = false;
  bool lockstep = false;  ///< after each message it waits for its `ack`; no schedule then
  bool restate = true;    ///< at the start, after a seek, at each turn
  Nanoseconds repeat = std::chrono::seconds(2);  ///< real time between two restatements; 0: none
  std::optional<Nanoseconds> gap_limit;          ///< real time
  bool read_ahead = true;                        ///< in a thread of its own
};

/// A player's tape deck: where it stands in the logs, whether it runs, and what is to be sent next.
/// It neither reads a clock nor waits nor sends: it is told what time it is, and asked.
///
/// It stands between two messages. All before that place has been told: sent, or said by the
/// restatement after the last jump, so that a receiver which folds everything from here has the
/// state of the place. `t` is the moment that goes with it: that of the last message sent, or that
/// was gone to, or what the clock says on the way from one message to the next.
///
/// One thread, but for the reading ahead.
class Playhead {
 public:
  enum class State : std::uint8_t { playing, paused, ended };

  /// Borrows the three; `tape` belongs to it alone.
  static Result<std::unique_ptr<Playhead>> open(MultiLogReader& tape, TapeFinder& finder,
                                                const PlayRoutes& routes,
                                                const PlayheadOptions& options, SteadyTime now);

  struct Next {
    Due due;
    SteadyTime deadline;
    bool immediate = false;  ///< a command asked for it: it goes also when paused
  };
  /// The next datagram, and when it is to go. Empty while nothing goes of itself: paused, ended,
  /// waiting for an `ack`. Asked again before take(), the same unless a command came.
  Result<std::optional<Next>> next(SteadyTime now);
  /// Takes what next() told; valid until the next call of anything.
  ByteView take(SteadyTime now);

  /// Does what a command asks for, but for the sending. An error leaves all as it was, unless the
  /// logs could not be read.
  Status execute(const PlayheadCommand& command, SteadyTime now);

  /// The process was stopped at `stopped` and went on at `now`: what would have been played in
  /// between is not made up for.
  void skipTime(SteadyTime stopped, SteadyTime now);

  /// "ok t=12.345678901 state=playing speed=1 sent=N"
  std::string status(SteadyTime now);
  LogTime time(SteadyTime now);
  State state();
  TapePosition place() const { return place_; }  ///< the next message lies at or behind it
  std::uint64_t sent() const { return sent_; }
  std::optional<PlaybackSpeed> speed() const { return options_.speed; }
  bool isPlaying() const { return playing_; }  ///< no pause was asked for, also at the end
  bool hasQuit() const { return quit_; }
  /// Lockstep: which message's `ack` it waits for; 0: for a peer to speak at all.
  std::optional<std::uint64_t> awaited() const { return awaited_; }

 private:
  /// What is being played; the tape is free again when it goes.
  struct Run {
    explicit Run(TapeStream stream) : tape(std::move(stream)) {}
    TapeStream tape;
    std::optional<ReadAhead> ahead;
    DatagramStream& stream() {
      if (ahead) return *ahead;
      return tape;
    }
  };

  Playhead(MultiLogReader& tape, TapeFinder& finder, const PlayRoutes& routes,
           const PlayheadOptions& options)
      : tape_(&tape), finder_(&finder), routes_(&routes), options_(options) {}

  Status begin(TapePosition place, LogTime moment, bool jump, SteadyTime now);
  Status jumpTo(LogTime moment, SteadyTime now);
  Status goBack(std::uint64_t count, SteadyTime now);
  Status goToEvent(bool forwards, SteadyTime now);
  Status setSpeed(const PlaybackSpeed& speed, SteadyTime now);
  Status setLoop(const PlayedSpan& loop, SteadyTime now);
  Status play(SteadyTime now);
  void freeze(SteadyTime now);
  void anchor(SteadyTime now);
  LogTime line(SteadyTime now);
  Status repeatIfDue(const std::optional<Due>& head, SteadyTime now);
  bool isImmediate(const Due& head) const;
  std::optional<Due> head();
  bool isScheduled() const { return options_.speed && !options_.lockstep; }

  MultiLogReader* tape_;
  TapeFinder* finder_;
  const PlayRoutes* routes_;
  PlayheadOptions options_;

  std::unique_ptr<Run> run_;
  bool playing_ = false;
  bool quit_ = false;
  bool starts_ = false;  ///< after a jump: time goes on when next() is asked
  PlaybackClock clock_{LogTime{}, SteadyTime{}, PlaybackSpeed()};

  TapePosition place_;      ///< where it stands
  TapePosition last_told_;  ///< the last message that was sent
  LogTime time_{};          ///< the moment of that, and ...
  LogTime line_{};          ///< ... where it lies on the run's own line
  std::uint32_t span_ = 0;
  PlayedSpan bounds_;  ///< of the span
  std::uint32_t turns_left_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t runs_ = 0;

  std::vector<RestatedDatagram> block_;  ///< said before anything of the run
  std::size_t block_taken_ = 0;
  SteadyTime asked_at_{};  ///< since when it is due, and what commands ask for
  SteadyTime repeat_at_{};
  bool in_block_ = false;           ///< a restatement of the run has begun
  std::uint64_t steps_ = 0;         ///< messages still to go at once
  std::optional<LogTime> through_;  ///< all of this moment is to go at once
  std::optional<std::uint64_t> awaited_;
  std::optional<Next> next_;
};

}  // namespace rocinante
