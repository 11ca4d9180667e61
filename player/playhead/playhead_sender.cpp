#include "player/playhead/playhead_sender.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "player/send/pacing.h"
#include "player/send/send_batch.h"

namespace rocinante {
namespace {

/// One command at a time, from its line to its answer.
class PendingCommand {
 public:
  PendingCommand(CommandSource* source, const PlayheadRules& rules)
      : source_(source), rules_(rules) {}

  /// True when there was a command.
  bool take(Playhead& playhead, SteadyTime now) {
    if (source_ == nullptr || open_) return false;
    const std::optional<std::string_view> line = source_->asked();
    if (!line) return false;
    open_ = true;
    error_.clear();
    const auto command = parsePlayheadCommand(*line, rules_.origin, rules_.end);
    const Status done = command ? playhead.execute(*command, now) : Status(command.error());
    if (!done) error_ = "error " + done.error().text();
    is_silent_ = done && command->kind == PlayheadCommand::Kind::ack;
    return true;
  }

  /// Answers when the command is done.
  void settle(Playhead& playhead, SteadyTime now, bool done) {
    if (!open_ || !done) return;
    open_ = false;
    std::string line = error_.empty() ? playhead.status(now) : error_;
    source_->answer(is_silent_ ? std::string() : std::move(line));
  }

 private:
  CommandSource* source_;
  const PlayheadRules& rules_;
  bool open_ = false;
  bool is_silent_ = false;
  std::string error_;
};

/// Announces each message and waits for its acknowledgement.
class AckWatch {
 public:
  AckWatch(CommandSource* source, Nanoseconds timeout) : source_(source), timeout_(timeout) {}

  void skipTime(Nanoseconds skipped) { since_ += skipped; }
  /// When judge() will fail if nobody acknowledges.
  SteadyTime deadline() const { return waits_ ? since_ + timeout_ : SteadyTime::max(); }

  Status judge(const Playhead& playhead, SteadyTime now) {
    const std::optional<std::uint64_t> awaited = playhead.lockstep().awaited();
    if (!awaited) {
      waits_ = false;
      return {};
    }
    if (!waits_ || *awaited != awaited_) {
      waits_ = true;
      awaited_ = *awaited;
      since_ = now;
      if (awaited_ > 0 && source_ != nullptr) source_->tell("step " + std::to_string(awaited_));
    }
    if (now < deadline()) return {};
    const std::string what = awaited_ == 0 ? std::string("no command reached the control endpoint")
                                           : "ack " + std::to_string(awaited_) + " did not arrive";
    return Error{ErrorKind::refused, what + " within --ack-timeout", {}};
  }

 private:
  CommandSource* source_;
  Nanoseconds timeout_;
  bool waits_ = false;
  std::uint64_t awaited_ = 0;
  SteadyTime since_{};
};

/// Who waits should know for how long, and how not to.
class SilenceTeller {
 public:
  explicit SilenceTeller(const PlayheadRules& rules) : rules_(rules) {}

  void look(const Playhead& playhead, const std::optional<Playhead::Next>& next, SteadyTime now) {
    constexpr Nanoseconds kLongSilence = std::chrono::minutes(1);
    if (!rules_.notify || !next || !playhead.isPlaying() || next->immediate) return;
    if (next->deadline - now <= kLongSilence) return;
    const TapePosition place = next->due.place;
    if (has_reported_ && reported_ == place) return;
    reported_ = place;
    has_reported_ = true;
    const std::string behind = secondsText(place.time - rules_.origin, 3);
    rules_.notify(fmt::format(
        "silent for {}, until {} s: --gap-limit 2s shortens silences, --from {}s begins behind it",
        roughDuration(next->deadline - now), behind, behind));
  }

 private:
  const PlayheadRules& rules_;
  TapePosition reported_{};  // not an optional: g++ 12 takes its value for uninitialised
  bool has_reported_ = false;
};

void publish(Playhead& playhead, const std::optional<Playhead::Next>& next, SteadyTime now,
             PlayStatus& status) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  status.position_ns.store(playhead.time(now).time_since_epoch().count(), kRelaxed);
  status.sent.store(playhead.sent(), kRelaxed);
  status.speed.store(playhead.speed() ? playhead.speed()->ratio() : 0, kRelaxed);
  status.state.store(static_cast<int>(playhead.state()), kRelaxed);
  status.next_ns.store(next ? next->deadline.time_since_epoch().count() : 0, kRelaxed);
}

}  // namespace

Result<SendEnd> sendPlayhead(Playhead& playhead, const PlayheadRules& rules, SendPort& port,
                             SendJournal& journal, CommandSource* commands, PlayStatus& status) {
  constexpr Nanoseconds kPublishEach = std::chrono::milliseconds(50);
  // Commands and signals end a sleep; a signal that comes just before it must not wait for long.
  constexpr Nanoseconds kLongestIdle = std::chrono::milliseconds(500);
  Pacing pacing;
  SendBatch batch;
  PendingCommand pending(commands, rules);
  AckWatch ack_watch(commands, rules.ack_timeout);
  SilenceTeller silence(rules);
  SteadyTime publish_at{};
  SteadyTime looked_at = port.now();
  while (!port.stopRequested()) {
    SteadyTime now = port.now();
    if (port.hasResumed()) {
      playhead.skipTime(looked_at, now);
      ack_watch.skipTime(now - looked_at);
    }
    looked_at = now;
    if (pending.take(playhead, now)) now = port.now();
    Result<std::optional<Playhead::Next>> next = playhead.next(now);
    if (!next) return next.error();
    pending.settle(playhead, now, !*next || !(*next)->immediate);
    if (playhead.hasQuit()) return SendEnd::stopped;
    if (const Status judged = ack_watch.judge(playhead, now); !judged) return judged.error();
    silence.look(playhead, *next, now);
    if (now >= publish_at) {
      publish(playhead, *next, now, status);
      publish_at = now + kPublishEach;
    }
    if (!*next) {
      // After stepping to the end the user may want to step back.
      const bool over = playhead.state() == Playhead::State::ended && playhead.isPlaying() &&
                        !playhead.lockstep().isWaiting();
      if (over && !rules.stays) return SendEnd::finished;
      publish(playhead, *next, now, status);
      port.sleepUntil(std::min({playhead.idleUntil(), ack_watch.deadline(), now + kLongestIdle}));
      continue;
    }
    const Pacing::Step step = pacing.step(now, (*next)->deadline);
    if (step.action == Pacing::Action::sleep) {
      port.sleepUntil(step.until);
      pacing.woke(step.until, port.now());
    }
    if (step.action != Pacing::Action::send) continue;
    pacing.sent((*next)->deadline);
    while (*next && !batch.full() && (*next)->deadline <= now) {
      const Playhead::Next taken = **next;
      ByteView payload = playhead.take(now);
      if (rules.signer != nullptr && taken.due.restated) payload = rules.signer->sign(payload);
      batch.add(taken.due, taken.deadline, payload);
      if (next = playhead.next(now); !next) break;
    }
    if (const Status sent = batch.send(port, journal); !sent) return sent.error();
    if (!next) return next.error();
  }
  return SendEnd::stopped;
}

}  // namespace rocinante
