#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "core/base/time.h"
#include "viewer/serve/feed.h"
#include "viewer/serve/foxglove_desk.h"
#include "viewer/serve/live_hub.h"

namespace rocinante {

/// A live session at the server's thread: what the feed hands over, folded.
class LiveSession {
 public:
  /// Borrows the cell.
  LiveSession(std::unique_ptr<Feed> feed, LiveHub::Options options, const Cell& cell)
      : feed_(std::move(feed)),
        desk_(cell, options.run),
        period_(static_cast<std::int64_t>(1e9 / options.rate_hz)),
        hub_(withDesk(std::move(options)), now()) {}
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  /// The wall clock of the start, continued by the steady one, so that it never goes back.
  LogTime now() const { return began_ + (std::chrono::steady_clock::now() - steady_); }

  /// Folds what has arrived; returns the changes, for clients that know the state so far.
  std::vector<SharedMessage> step() {
    std::vector<SharedMessage> messages;
    const LogTime time = now();
    if (feed_->take(batch_)) {
      std::size_t begin = 0;
      for (const std::size_t end : batch_.ends) {
        hub_.receive(ByteView(batch_.bytes).subspan(begin, end - begin), time);
        begin = end;
      }
    }
    hub_.advance(time);
    if (SharedMessage message = hub_.takeMessage(time)) messages.push_back(std::move(message));
    return messages;
  }
  /// How long there is nothing to do, if nothing arrives.
  Nanoseconds idle() const {
    return hub_.due() == LogTime::max() ? Nanoseconds::max() : hub_.due() - now();
  }

  /// Brings the desk up to date, not more often than the rate; true when it did.
  bool fillDesk() {
    const LogTime time = now();
    if (time - filled_ < period_) return false;
    filled_ = time;
    desk_.moment(time, hub_.state());
    return true;
  }
  const FoxgloveDesk& desk() const { return desk_; }
  const LiveHub& hub() const { return hub_; }
  const Feed& feed() const { return *feed_; }

 private:
  LiveHub::Options withDesk(LiveHub::Options options) {
    options.applied = [this](const Packet& packet, const std::vector<Event>& events) {
      desk_.applied(packet, events);
    };
    return options;
  }

  std::chrono::steady_clock::time_point steady_ = std::chrono::steady_clock::now();
  LogTime began_{
      std::chrono::duration_cast<Nanoseconds>(std::chrono::system_clock::now().time_since_epoch())};
  std::unique_ptr<Feed> feed_;
  Feed::Batch batch_;
  FoxgloveDesk desk_;
  Nanoseconds period_;
  LogTime filled_{};
  LiveHub hub_;  // its options refer to the desk
};

}  // namespace rocinante
