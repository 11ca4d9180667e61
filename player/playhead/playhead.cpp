#include "player/playhead/playhead.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

using Kind = PlayheadCommand::Kind;

/// Time between a restatement and the next message, so that it delays none.
constexpr Nanoseconds kLead = std::chrono::milliseconds(5);
/// A deferred restatement begins only in a silence longer than this.
constexpr Nanoseconds kSilence = std::chrono::milliseconds(100);
/// While playing, `previous` skips events that have just passed.
constexpr Nanoseconds kJustNow = std::chrono::seconds(1);

Error refused(std::string what) { return {ErrorKind::refused, std::move(what), {}}; }

/// The next of the usual speeds.
PlaybackSpeed neighbour(PlaybackSpeed speed, bool faster) {
  static constexpr std::array kUsual = {"0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1",   "2",
                                        "5",    "10",   "20",   "50",  "100", "200", "500", "1000"};
  PlaybackSpeed found = speed;
  for (const char* text : kUsual) {
    const PlaybackSpeed usual = *PlaybackSpeed::parse(text);
    if (faster && usual.ratio() > speed.ratio()) return usual;
    if (!faster && usual.ratio() < speed.ratio()) found = usual;
  }
  return found;
}

std::string_view nameOf(Playhead::State state) {
  if (state == Playhead::State::ended) return "ended";
  return state == Playhead::State::playing ? "playing" : "paused";
}

}  // namespace

Result<std::unique_ptr<Playhead>> Playhead::open(MultiLogReader& tape, TapeFinder& finder,
                                                 const PlayRoutes& routes,
                                                 const PlayheadOptions& options, SteadyTime now) {
  std::unique_ptr<Playhead> playhead(new Playhead(tape, finder, routes, options));
  playhead->turns_left_ = options.turns == 0 ? 0 : options.turns - 1;
  playhead->playing_ = !options.start_paused;
  const LogTime from = options.start.value_or(options.span.from);
  if (const Status begun = playhead->begin(TapePosition::at(from), from, true, now); !begun) {
    return begun.error();
  }
  return playhead;
}

/// Plays on from `place`, starting now; restates everything first after a jump.
Status Playhead::begin(TapePosition place, LogTime moment, bool jump, SteadyTime now) {
  run_.reset();
  next_.reset();
  TapeRun run;
  run.from = place_ = place;
  run.start = time_ = line_ = moment;
  // An interrupted restatement must be repeated.
  const bool restates = jump || in_block_;
  in_block_ = false;
  if (jump && runs_ > 0) ++span_;
  if (jump) bounds_.from = moment;
  run.span = span_;
  const bool is_looping = options_.loop && moment < options_.loop->until;
  run.turn = is_looping ? *options_.loop : options_.span;
  run.endless = is_looping || options_.turns == 0;
  run.turns_left = turns_left_;
  run.bounds = bounds_ = {bounds_.from, run.turn.until};
  run.part_id = "player" + std::to_string(++runs_);
  run.restated_bytes = options_.restated_bytes;
  if (isScheduled() && options_.gap_limit) {
    run.gap_limit = options_.speed->logDuration(*options_.gap_limit);
  }
  if (restates) restatements_.clear(now);
  if (options_.restate) {
    Result<SessionState> state = finder_->stateBefore(place);
    if (!state) return state.error();
    if (run.endless || run.turns_left > 0) {
      Result<SessionState> turn_state = finder_->stateBefore(TapePosition::at(run.turn.from));
      if (!turn_state) return turn_state.error();
      run.turn_state = std::move(*turn_state);
    }
    run.sources = finder_->sources();
    if (restates) restatements_.begin(*state, run.sources, run.part_id, now);
    run.state = std::move(*state);
    if (isScheduled() && options_.repeat.count() > 0) {
      run.repeat = options_.speed->logDuration(options_.repeat);
    }
  }
  if (jump) {
    steps_ = 0;
    through_.reset();
    last_sent_ = {};
  }
  Result<TapeStream> tape = TapeStream::open(*tape_, *routes_, std::move(run));
  if (!tape) return tape.error();
  run_ = std::make_unique<Run>(std::move(*tape));
  // At the start there is time to fill the memory before the first deadline.
  if (options_.read_ahead) run_->ahead.emplace(run_->tape, runs_ == 1 && options_.speed);
  restatements_.restamp(now);
  starts_ = starts_ || jump;
  anchor(now);
  return {};
}

void Playhead::anchor(SteadyTime now) {
  if (options_.speed) clock_ = PlaybackClock(line_, now, *options_.speed);
}

std::optional<Due> Playhead::head() {
  Result<std::optional<Due>> head = run_->stream().due();
  return head ? *head : std::nullopt;
}

/// The clock's position on the run's time line, never beyond the next datagram.
LogTime Playhead::line(SteadyTime now) {
  if (!playing_ || !isScheduled()) return line_;
  const std::optional<Due> head = this->head();
  if (!head) return line_;
  return std::max(line_, std::min(clock_.moment(now), head->time));
}

LogTime Playhead::time(SteadyTime now) {
  LogTime time = time_ + (line(now) - line_);
  const std::optional<Due> head = this->head();
  if (head && head->span == span_) time = std::min(time, head->place.time);
  return std::max(time_, std::min(time, bounds_.until - Nanoseconds(1)));
}

void Playhead::freeze(SteadyTime now) {
  const LogTime time = this->time(now);
  line_ = line(now);
  time_ = time;
}

void Playhead::skipTime(SteadyTime stopped, SteadyTime now) {
  freeze(stopped);
  anchor(now);
}

Playhead::State Playhead::state() {
  if (!head()) return State::ended;
  return playing_ ? State::playing : State::paused;
}

std::string Playhead::status(SteadyTime now) {
  return "ok t=" + secondsText(time(now) - options_.origin, 9) +
         " state=" + std::string(nameOf(state())) +
         " speed=" + (options_.speed ? options_.speed->text() : "asap") +
         " sent=" + std::to_string(sent_);
}

bool Playhead::isImmediate(const Due& head) const {
  if (steps_ > 0 || in_block_) return true;
  if (through_ && head.span == span_ && head.place.time <= *through_) return true;
  // A restatement caused by the message just sent belongs to it.
  return head.restated && head.place == last_sent_;
}

/// Restates everything when it is due and there is time: while paused, or in a silence. While
/// messages come, the run does it itself.
Status Playhead::repeatIfDue(const std::optional<Due>& head, SteadyTime now) {
  if (!restatements_.isDue(now)) return {};
  const bool runs = playing_ && head && !lockstep_.isWaiting();
  if (runs && (!isScheduled() || clock_.deadline(head->time) - now < kSilence)) return {};
  Result<SessionState> state = finder_->stateBefore(place_);
  if (!state) return state.error();
  restatements_.begin(*state, finder_->sources(), "player" + std::to_string(++runs_), now);
  // This interrupts a restatement of a source, so the run must restate until that is complete.
  if (state->restatementOpen(time_)) {
    freeze(now);
    return begin(place_, time_, false, now);
  }
  return {};
}

Result<std::optional<Playhead::Next>> Playhead::next(SteadyTime now) {
  next_.reset();
  if (quit_) return next_;
  if (std::exchange(starts_, false)) {
    // The time for reading and folding must not be made up for.
    restatements_.restamp(now);
    anchor(restatements_.isSending() ? now + kLead : now);
  }
  if (!restatements_.isSending()) {
    Result<std::optional<Due>> head = run_->stream().due();
    if (!head) return head.error();
    const bool immediate = *head && isImmediate(**head);
    if (!immediate) {
      if (const Status repeated = repeatIfDue(*head, now); !repeated) return repeated.error();
    }
    if (!restatements_.isSending()) {
      if (!*head || (lockstep_.isWaiting() && !(*head)->restated)) return next_;
      if (immediate) {
        next_ = Next{**head, now, true};
      } else if (playing_) {
        next_ = Next{**head, isScheduled() ? clock_.deadline((*head)->time) : now, false};
      }
      return next_;
    }
  }
  Due due{line_, span_, true, false, restatements_.route(), bounds_, place_};
  next_ = Next{due, std::min(restatements_.askedAt(), now), true};
  return next_;
}

ByteView Playhead::take(SteadyTime now) {
  const Due& due = next_->due;
  if (restatements_.isSending()) return restatements_.take(now);
  if (due.restated) restatements_.postpone(now);
  if (due.span != span_) {
    span_ = due.span;
    if (!options_.loop && turns_left_ > 0) --turns_left_;
    bounds_ = due.bounds;
    time_ = bounds_.from;
    place_ = TapePosition::at(bounds_.from);
    line_ = due.time;
    through_.reset();
  }
  const ByteView payload = run_->stream().take();
  if (due.restated) {
    in_block_ = due.continues;
    // It also covers messages before the next one that are not played: restatements by others.
    if (!in_block_) place_ = std::max(place_, due.place);
    return payload;
  }
  place_ = TapePosition::behind(due.place);
  last_sent_ = due.place;
  time_ = due.place.time;
  line_ = due.time;
  ++sent_;
  if (steps_ > 0) --steps_;
  lockstep_.send(sent_);
  return payload;
}

Status Playhead::jumpTo(LogTime moment, SteadyTime now) {
  const LogTime within = std::clamp(moment, options_.span.from, options_.span.until);
  return begin(TapePosition::at(within), within, true, now);
}

Status Playhead::goBack(std::uint64_t count, SteadyTime now) {
  const Result<MultiLogReader::Earlier> earlier = finder_->back(place_, count, options_.span.from);
  if (!earlier) return earlier.error();
  return begin(earlier->place, earlier->before.value_or(options_.span.from), true, now);
}

Status Playhead::goToEvent(bool forwards, SteadyTime now) {
  const Result<const std::vector<LogTime>*> events = finder_->eventTimes();
  if (!events) return events.error();
  const std::vector<LogTime>& times = **events;
  // Events up to and including this time have been played.
  LogTime reached = time(now);
  if (const std::optional<Due> head = this->head(); head && head->span == span_) {
    reached = std::min(reached, head->place.time - Nanoseconds(1));
  }
  if (!forwards && playing_ && isScheduled()) reached -= options_.speed->logDuration(kJustNow);
  auto found = forwards ? std::upper_bound(times.begin(), times.end(), reached)
                        : std::lower_bound(times.begin(), times.end(), reached);
  const bool is_there = forwards ? found != times.end() : found != times.begin();
  if (is_there && !forwards) --found;
  if (!is_there || *found < options_.span.from || *found >= options_.span.until) {
    return refused(forwards ? "no event comes after this" : "no event came before this");
  }
  if (const Status begun = begin(TapePosition::at(*found), *found, true, now); !begun) return begun;
  through_ = *found;
  return {};
}

Status Playhead::setSpeed(const PlaybackSpeed& speed, SteadyTime now) {
  if (!isScheduled()) return refused("the speed cannot change: nothing is sent on a schedule");
  freeze(now);
  options_.speed = speed;
  // Restatements and silences were computed for the old speed.
  if (options_.gap_limit || (options_.restate && options_.repeat.count() > 0)) {
    return begin(place_, time_, false, now);
  }
  anchor(now);
  return {};
}

Status Playhead::setLoop(const PlayedSpan& loop, SteadyTime now) {
  const PlayedSpan within{std::max(loop.from, options_.span.from),
                          std::min(loop.until, options_.span.until)};
  if (within.from >= within.until) return refused("the loop is outside the played range");
  const Result<bool> any = finder_->anyIn(within.from, within.until);
  if (!any) return any.error();
  if (!*any) return refused("the loop contains no message");
  freeze(now);
  options_.loop = within;
  if (time_ >= within.until || state() == State::ended) return jumpTo(within.from, now);
  return begin(place_, time_, false, now);
}

Status Playhead::play(SteadyTime now) {
  const bool was_over = state() == State::ended;
  if (was_over) {
    playing_ = true;
    return jumpTo(options_.loop ? options_.loop->from : options_.span.from, now);
  }
  if (!playing_) anchor(now);
  playing_ = true;
  return {};
}

Status Playhead::execute(const PlayheadCommand& command, SteadyTime now) {
  lockstep_.hear();
  switch (command.kind) {
    case Kind::play:
      return play(now);
    case Kind::toggle:
      if (!playing_ || state() == State::ended) return play(now);
      [[fallthrough]];
    case Kind::pause:
      freeze(now);
      playing_ = false;
      return {};
    case Kind::step:
      freeze(now);
      playing_ = false;
      steps_ = command.count;
      restatements_.restamp(now);
      return {};
    case Kind::back:
      freeze(now);
      playing_ = false;
      return goBack(command.count, now);
    case Kind::move: {
      std::int64_t moment = 0;
      const LogTime here = time(now);
      const bool over = __builtin_add_overflow(here.time_since_epoch().count(),
                                               command.duration.count(), &moment);
      if (over)
        moment = (command.duration.count() < 0 ? LogTime::min() : LogTime::max())
                     .time_since_epoch()
                     .count();
      return jumpTo(LogTime(Nanoseconds(moment)), now);
    }
    case Kind::next:
    case Kind::previous:
      return goToEvent(command.kind == Kind::next, now);
    case Kind::seek:
      return jumpTo(command.from, now);
    case Kind::speed:
      return setSpeed(command.speed, now);
    case Kind::faster:
    case Kind::slower:
      return setSpeed(
          neighbour(options_.speed.value_or(PlaybackSpeed()), command.kind == Kind::faster), now);
    case Kind::loop:
      return setLoop({command.from, command.until}, now);
    case Kind::loop_off:
      freeze(now);
      options_.loop.reset();
      options_.turns = 1;
      turns_left_ = 0;
      return begin(place_, time_, false, now);
    case Kind::quit:
      freeze(now);
      quit_ = true;
      return {};
    case Kind::ack:
      return lockstep_.acknowledge(command.count);
    case Kind::status:
      return {};
  }
  return {};
}

}  // namespace rocinante
