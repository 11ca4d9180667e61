// The part of ViewModel for growing sessions: live ones and logs that are being written.
#include <algorithm>
#include <thread>
#include <utility>

#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// How often to look at the log: while it is shown and the picture waits for it, and otherwise.
constexpr Nanoseconds kSoon = 30ms;
constexpr Nanoseconds kSometimes = 250ms;
constexpr Nanoseconds kFinishWait = 2s;

}  // namespace

bool ViewModel::goToNow() {
  if (feed_ && !cursor_) return true;
  if (!cursor_ || !log_grows_) return false;
  cursor_->followNow();
  return true;
}

void ViewModel::takeLive(ViewModel& from) {
  names_->expectOthers();
  feed_ = std::exchange(from.feed_, std::nullopt);
  live_ = std::move(from.live_);
  heard_ = from.heard_;
  live_since_ = from.live_since_;
  last_arrival_ = from.last_arrival_;
  live_at_ = from.live_at_;
  keeping_trouble_ = from.keeping_trouble_;
}

bool ViewModel::hear(SteadyTime now) {
  if (!live_since_) live_since_ = now;
  const bool follows = showsNow();
  if (was_following_ && !follows && heard_) {
    // The user has just left now, at the moment that is shown.
    left_now_.emplace(LeftNow{live_->time, live_->state});
  }
  if (follows) left_now_.reset();
  was_following_ = follows;
  const std::uint64_t before = live_->datagrams;
  const bool is_shown = received_ == &live_->state;
  if (!feed_->update(*live_)) return false;
  heard_ = true;
  if (live_->datagrams > before) last_arrival_ = now;
  live_at_ = now;
  return is_shown;
}

bool ViewModel::openKeptLog() {
  const LiveKeeper* const keeper = feed_->keeper();
  if (keeper == nullptr) return false;
  const KeptProgress kept = keeper->progress();
  if (!kept.trouble.empty()) keeping_trouble_ = "this session is no longer kept: " + kept.trouble;
  if (session_ || kept.first.empty()) return false;
  auto opened = Timeline::follow(kept.first);
  // It may have no message yet.
  if (!opened.ok() || opened->log().summary().messages == 0) return false;
  session_ = std::move(*opened);
  log_grows_ = true;
  cursor_.emplace(session_->start(), std::max(session_->end(), live_->time));
  cursor_->setGrowing(true);
  cursor_->followNow();
  return true;
}

bool ViewModel::watchLog(SteadyTime now) {
  const bool waits =
      cursor_ && session_ && (cursor_->following() ? !feed_ : shownTime() > session_->end());
  bool shows_more = false;
  if (!log_watched_ || now - *log_watched_ >= (waits ? kSoon : kSometimes)) {
    log_watched_ = now;
    if (feed_ && openKeptLog()) takeOverLog();
    if (session_) {
      const auto grown = session_->refresh();
      if (!grown.ok()) {
        loseLog(grown.error());
      } else if (*grown) {
        takeOverLog();
        shows_more = waits;
      }
    }
  }
  // Now is where the network is, not where the file is.
  if (cursor_ && feed_ && heard_) {
    // What is no longer kept cannot be shown again.
    const LogTime newest = keeping_trouble_.empty() ? live_->time : session_->end();
    cursor_->resize(session_->start(), std::max(session_->end(), newest));
    viewer.time_view.resize(cursor_->start(), cursor_->end());
  }
  return shows_more;
}

/// Makes what was written part of what can be shown.
void ViewModel::takeOverLog() {
  if (!feed_) {
    cursor_->resize(session_->start(), session_->end());
    viewer.time_view.resize(cursor_->start(), cursor_->end());
  }
  StateDamage hiding;  // the panel counts all places of damage
  const auto events = session_->events(&hiding);
  if (!events.ok()) {
    viewer.panels.complaint = events.error().text();
  } else if (events_.size() != (*events)->size() ||
             (!events_.empty() && events_.front().time != (*events)->front().time)) {
    events_ = **events;
  }
  // The state was borrowed from the log as it was.
  if (!showsNow() || !feed_) {
    if (auto again = showMoment(shownTime()); !again) {
      receive(empty_state_);
      return loseLog(again.error());
    }
  }
  if (feed_) return;
  recorded_losses_ = 0;
  for (const LossSpan& span : session_->log().losses()) {
    recorded_losses_ += span.counts.kernel + span.counts.queue + span.counts.disk;
  }
  log_grows_ = session_->growing();
  cursor_->setGrowing(log_grows_);
}

/// The log cannot be read any more. A live session continues without its past.
void ViewModel::loseLog(const Error& error) {
  if (!feed_) {
    viewer.panels.complaint = error.text();
    log_grows_ = false;
    if (cursor_) cursor_->setGrowing(false);
    return;
  }
  keeping_trouble_ = "earlier moments of this session cannot be shown: " + error.text();
  if (heard_) receive(live_->state);  // it may have been borrowed from the log
  extras_.trails.clear();
  session_.reset();
  cursor_.reset();
  walker_.reset();
  events_.clear();
  left_now_.reset();
  log_grows_ = false;
}

Status ViewModel::showMoment(LogTime moment) {
  if (left_now_ && left_now_->time == moment && session_->end() < moment) {
    damage_ = {};
    if (auto trails = findTrails(moment); !trails) return trails;
    receive(left_now_->state);
    return {};
  }
  return findState(moment);
}

Result<std::filesystem::path> ViewModel::logOfShownMoment() {
  if (!session_) {
    return Error{ErrorKind::bad_argument,
                 feed_ ? "nothing of this live session has been kept yet" : "this needs a log",
                 {}};
  }
  const LogTime moment = shownTime();
  LiveKeeper* const keeper = feed_ ? feed_->keeper() : nullptr;
  if (keeper != nullptr && keeper->progress().finished_until <= moment) {
    keeper->finishUpTo(moment);
    const SteadyTime began = std::chrono::steady_clock::now();
    while (keeper->progress().finished_until <= moment) {
      if (SteadyTime(std::chrono::steady_clock::now()) - began > kFinishWait) {
        return Error{ErrorKind::refused, "the kept log could not be finished in time", {}};
      }
      std::this_thread::sleep_for(5ms);
    }
  }
  if (keeper != nullptr) {
    const auto grown = session_->refresh();
    if (!grown.ok()) return grown.error();
    takeOverLog();
    // This frame draws it, before the next update.
    state_ = hand.over(*received_, moment);
    if (auto posed = pose(moment); !posed) return posed.error();
    if (!session_) return Error{ErrorKind::unreadable, keeping_trouble_, {}};
  }
  return std::filesystem::path(session_->logAt(moment).name());
}

std::optional<Nanoseconds> ViewModel::liveSilence(SteadyTime now) const {
  if (!feed_ || !live_since_) return std::nullopt;
  return now - last_arrival_.value_or(*live_since_);
}

std::optional<Finding> ViewModel::liveReason(SteadyTime now) const {
  const std::optional<Nanoseconds> silent = liveSilence(now);
  if (!silent) return std::nullopt;
  LiveFacts facts;
  facts.endpoints = feed_->endpoints();
  facts.watched = now - *live_since_;
  facts.silent = *silent;
  if (heard_) {
    facts.datagrams = live_->datagrams;
    facts.undecoded = live_->undecoded;
    facts.untrusted = live_->untrusted;
    facts.undecoded_sample = live_->undecoded_sample;
    facts.news = live_->news;
    facts.devices_spoken_of = live_->state.devices().size();
    facts.only_windows = !live_->sources.empty();
    std::optional<SteadyTime> machine_heard;
    for (const LiveSource& source : live_->sources) {
      const bool left = others_.hasLeft(source.name);
      const bool is_window = left || live_->state.views().contains(source.name);
      facts.only_windows = facts.only_windows && is_window;
      facts.any_window = facts.any_window || (is_window && !left);
      if (!is_window) machine_heard = std::max(machine_heard, std::optional(source.heard));
    }
    // What is no packet is of no window either.
    if (machine_heard && facts.undecoded == 0) facts.silent = feedTime(now) - *machine_heard;
    bool any_known = false;
    for (const auto& [name, device] : live_->state.devices()) {
      any_known = any_known || scene_.findDevice(name) != nullptr;
      if (facts.unknown_device.empty()) facts.unknown_device = name;
    }
    if (any_known) facts.unknown_device.clear();
  }
  return rocinante::liveReason(facts);
}

std::vector<SourceRow> ViewModel::sourceRows(SteadyTime now) const {
  if (!heard_) return rocinante::sourceRows({}, *cell_, {});
  auto rows = rocinante::sourceRows(live_->sources, *cell_, feedTime(now));
  std::erase_if(rows, [this](const SourceRow& row) {
    return others_.hasLeft(row.name) &&
           std::ranges::find(cell_->sources, row.name, &CellSource::name) == cell_->sources.end();
  });
  return rows;
}

SteadyTime ViewModel::feedTime(SteadyTime now) const {
  return live_->taken + (live_at_ ? now - *live_at_ : Nanoseconds(0));
}

}  // namespace rocinante
