#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "player/logs/multi_log_reader.h"
#include "player/logs/play_routes.h"
#include "player/logs/read_ahead.h"
#include "player/logs/tape_finder.h"
#include "player/logs/tape_stream.h"
#include "player/playhead/lockstep.h"
#include "player/playhead/playhead_command.h"
#include "player/playhead/restatement_schedule.h"
#include "player/send/datagram_stream.h"
#include "player/send/playback_clock.h"

namespace rocinante {

struct PlayheadOptions {
  PlayedSpan span;                 ///< the range to play
  std::optional<LogTime> start;    ///< where to begin; empty: at the start of `span`
  std::uint32_t turns = 1;         ///< over the whole span; 0: endless
  std::optional<PlayedSpan> loop;  ///< repeated endlessly once it is reached; within `span`
  LogTime origin{}, end{};         ///< reference of the times in commands and answers
  std::optional<PlaybackSpeed> speed = PlaybackSpeed();  ///< empty: without a schedule
  bool start_paused = false;
  bool lockstep = false;  ///< wait for an `ack` after each message, without a schedule
  bool restate = true;    ///< at the start, after a seek, at each turn
  Nanoseconds repeat = std::chrono::seconds(2);  ///< real time between restatements; 0: none
  std::size_t restated_bytes = 1200;             ///< the largest datagram of a restatement
  std::optional<Nanoseconds> gap_limit;          ///< real time
  bool read_ahead = true;                        ///< in a separate thread
};

/// A player's position in the logs, whether it runs, and what to send next. It does not read a
/// clock, wait or send: callers pass the time and ask.
///
/// The position lies between two messages. Everything before it has been sent, or was covered by
/// the restatement after the last jump, so a receiver has the state of that place. `t` is the
/// matching moment: that of the last message sent, the target of a jump, or the clock's time
/// between two messages.
///
/// One thread, except for reading ahead.
class Playhead {
 public:
  enum class State : std::uint8_t { playing, paused, ended };

  /// Borrows all three; nothing else may use `tape`.
  static Result<std::unique_ptr<Playhead>> open(MultiLogReader& tape, TapeFinder& finder,
                                                const PlayRoutes& routes,
                                                const PlayheadOptions& options, SteadyTime now);

  struct Next {
    Due due;
    SteadyTime deadline;
    bool immediate = false;  ///< a command asked for it: send even while paused
  };
  /// The next datagram and its due time. Empty while nothing is due: paused, ended, or waiting for
  /// an `ack`. The same until take() or a command.
  Result<std::optional<Next>> next(SteadyTime now);
  /// While next() is empty and no command comes, it stays so until then.
  SteadyTime idleUntil() const { return restatements_.dueAt(); }
  /// Takes the datagram of next(); valid until the next call of any function.
  ByteView take(SteadyTime now);

  /// Executes a command, except for sending. An error changes nothing, unless the logs could not be
  /// read.
  Status execute(const PlayheadCommand& command, SteadyTime now);

  /// The process was stopped at `stopped` and continued at `now`: the time between is not made up
  /// for.
  void skipTime(SteadyTime stopped, SteadyTime now);

  /// "ok t=12.345678901 state=playing speed=1 sent=N"
  std::string status(SteadyTime now);
  LogTime time(SteadyTime now);
  State state();
  TapePosition place() const { return place_; }  ///< the next message is at or after it
  std::uint64_t sent() const { return sent_; }
  std::optional<PlaybackSpeed> speed() const { return options_.speed; }
  bool isPlaying() const { return playing_; }  ///< not paused; also true at the end
  bool hasQuit() const { return quit_; }
  const Lockstep& lockstep() const { return lockstep_; }

 private:
  /// The stream being played. Its destruction frees the tape.
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
      : tape_(&tape),
        finder_(&finder),
        routes_(&routes),
        options_(options),
        restatements_(routes, options.restate ? options.repeat : Nanoseconds(0),
                      options.restated_bytes),
        lockstep_(options.lockstep) {}

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
  bool starts_ = false;  ///< after a jump: time starts at the next call of next()
  PlaybackClock clock_{LogTime{}, SteadyTime{}, PlaybackSpeed()};

  TapePosition place_;      ///< the position
  TapePosition last_sent_;  ///< the last message sent
  LogTime time_{};          ///< its moment, and ...
  LogTime line_{};          ///< ... its time on the run's own line
  std::uint32_t span_ = 0;
  PlayedSpan bounds_;  ///< of the current span
  std::uint32_t turns_left_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t runs_ = 0;

  RestatementSchedule restatements_;  ///< of what lies before place_: sent before the run continues
  bool in_block_ = false;             ///< a restatement of the run has begun
  std::uint64_t steps_ = 0;           ///< messages still to send at once
  std::optional<LogTime> through_;    ///< send all messages up to this moment at once
  Lockstep lockstep_;
  std::optional<Next> next_;
};

}  // namespace rocinante
