#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/packet/packet_text.h"
#include "player/playhead/playhead.h"
#include "tests/player/logs/written_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// A playhead with a simulated clock, and a receiver that folds everything sent.
class Deck {
 public:
  explicit Deck(std::vector<std::filesystem::path> logs, PlayheadOptions options = {},
                ChannelChoice choice = {})
      : tape_(std::make_unique<MultiLogReader>(MultiLogReader::open(logs, choice).value())),
        finder_(std::make_unique<TapeFinder>(TapeFinder::open(logs, choice).value())),
        routes_(std::make_unique<PlayRoutes>(
            makeRoutes(*tape_, Endpoint::standard(), {}, false).value())) {
    if (options.span.until == LogTime{}) {
      options.span = {tape_->start(), tape_->end() + Nanoseconds(1)};
    }
    options.origin = tape_->origin();
    options.end = tape_->end();
    options.read_ahead = false;
    span_ = options.span;
    origin_ = options.origin;
    end_ = options.end;
    playhead_ = Playhead::open(*tape_, *finder_, *routes_, options, now_).value();
  }

  Playhead& playhead() { return *playhead_; }
  TapeFinder& finder() { return *finder_; }
  PlayedSpan span() const { return span_; }

  /// Advances the time, and sends each datagram exactly when it is due.
  void playFor(Nanoseconds span, std::size_t most = 1'000'000) {
    const SteadyTime until = now_ + span;
    // A sender also looks when nothing is due.
    constexpr Nanoseconds kLook = std::chrono::milliseconds(50);
    while (true) {
      const auto next = playhead_->next(now_).value();
      // Immediate datagrams complete what was begun.
      if (most == 0 && !(next && next->immediate)) return;
      if (next && next->deadline <= now_) {
        if (most > 0) --most;
        hear(*next);
        continue;
      }
      if (now_ >= until) return;
      now_ = std::min(until, now_ + kLook);
      if (next) now_ = std::min(now_, next->deadline);
    }
  }

  /// Advances the time without asking the playhead, as on a busy machine.
  void sleepFor(Nanoseconds span) { now_ += span; }

  /// Executes one command with everything due at once, and returns the answer.
  std::string say(const std::string& line) {
    const auto command = parsePlayheadCommand(line, origin_, end_);
    if (!command) return "error " + command.error().text();
    const Status done = playhead_->execute(*command, now_);
    while (true) {
      const auto next = playhead_->next(now_).value();
      if (!next || !next->immediate) break;
      hear(*next);
    }
    return done ? playhead_->status(now_) : "error " + done.error().text();
  }

  const std::vector<std::string>& payloads() const { return payloads_; }
  const std::vector<std::string>& restatements() const { return restatements_; }
  /// One for each message sent.
  const std::vector<Due>& dues() const { return dues_; }
  std::vector<std::uint32_t> spans() const {
    std::vector<std::uint32_t> spans;
    for (const Due& due : dues_) spans.push_back(due.span);
    return spans;
  }

  const SessionState& receiver() const { return receiver_; }

  /// Expects the receiver's state to be the fold of the logs at this place.
  void expectStateOfPlace() {
    const SessionState wanted = finder_->stateBefore(playhead_->place()).value();
    EXPECT_EQ(itemsOf(receiver_), itemsOf(wanted));
  }

  /// The items and sources of a state as text, without times of arrival.
  static std::string itemsOf(const SessionState& state) {
    std::string text;
    const std::string identity = state.identityText();
    for (std::size_t begin = 0; begin < identity.size();) {
      const std::size_t end = identity.find('\n', begin);
      const std::string line = identity.substr(begin, end - begin + 1);
      if (line.starts_with("item ")) text += line;
      // A source that was only reset is known without having sent anything.
      if (line.starts_with("source ") && !line.ends_with(" - -\n")) text += line;
      begin = end == identity.npos ? identity.size() : end + 1;
    }
    return text;
  }

 private:
  void hear(const Playhead::Next& next) {
    const ByteView payload = playhead_->take(now_);
    const std::string text(textOf(payload));
    if (next.due.restated) {
      restatements_.push_back(text);
    } else {
      // Spaced as in the log at any speed: a restatement lasts a second of log time.
      const Nanoseconds gap = next.due.place.time - heard_.time;
      if (heard_.time != LogTime{} && gap.count() > 0) heard_at_ += gap;
      heard_ = next.due.place;
      payloads_.push_back(text);
      dues_.push_back(next.due);
    }
    if (const Packet* packet = decoder_.decode(bytesOf(text))) receiver_.apply(heard_at_, *packet);
    receiver_.takeEvents();
  }

  std::unique_ptr<MultiLogReader> tape_;
  std::unique_ptr<TapeFinder> finder_;
  std::unique_ptr<PlayRoutes> routes_;
  PlayedSpan span_;
  LogTime origin_{}, end_{};
  SteadyTime now_{std::chrono::seconds(1)};
  std::unique_ptr<Playhead> playhead_;

  std::vector<std::string> payloads_, restatements_;
  std::vector<Due> dues_;
  TapePosition heard_;
  LogTime heard_at_{std::chrono::seconds(1)};
  PacketTextDecoder decoder_;
  SessionState receiver_;
};

}  // namespace rocinante::test
