#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "player/send/paced_sender.h"

namespace rocinante::test {

/// A simulated SendPort in which time passes only while waiting or sending.
class FakeSendPort : public SendPort {
 public:
  SteadyTime now() override {
    time_ += look_costs;
    ++looks;
    return time_;
  }
  void sleepUntil(SteadyTime moment) override {
    ++sleeps;
    if (moment > time_) {
      slept += moment - time_;
      longest_sleep = std::max(longest_sleep, moment - time_);
      time_ = moment + wakes_late;
    }
  }
  bool stopRequested() override { return sends >= stop_after_sends; }
  bool hasResumed() override {
    if (sends != stopped_after_sends) return false;
    stopped_after_sends = 0;
    return true;
  }
  Status send(std::uint16_t route, std::span<const ByteView> payloads,
              std::span<SteadyTime> sent_at) override {
    ++sends;
    if (fail_send == sends) return Error{ErrorKind::refused, "the network is gone", "udp://x"};
    for (std::size_t i = 0; i < payloads.size(); ++i) {
      time_ += send_costs;
      sent_at[i] = time_;
      if (keep_payloads) sent.emplace_back(textOf(payloads[i]));
      if (keep_payloads) routes.push_back(route);
    }
    if (sends == stopped_after_sends) time_ += stopped_for;
    return {};
  }

  Nanoseconds look_costs{100};
  Nanoseconds wakes_late{10'000};
  Nanoseconds send_costs{1'000};
  std::size_t stop_after_sends = static_cast<std::size_t>(-1);
  std::size_t stopped_after_sends = 0;  ///< stop the process then, for `stopped_for`
  Nanoseconds stopped_for{};
  std::size_t fail_send = 0;  ///< number of the call that fails, from 1
  bool keep_payloads = true;

  std::vector<std::string> sent;
  std::vector<std::uint16_t> routes;  ///< of each of `sent`
  std::size_t looks = 0, sleeps = 0, sends = 0;
  Nanoseconds slept{}, longest_sleep{};

 private:
  SteadyTime time_{};
};

/// A stream of the test's datagrams.
class FakeStream : public DatagramStream {
 public:
  struct Item {
    Due due;
    std::string payload;
  };
  explicit FakeStream(std::vector<Item> items) : items_(std::move(items)) {}

  Result<std::optional<Due>> due() override {
    if (next_ == fail_at) return Error{ErrorKind::damaged, "chunk 7 fails its checksum", "x.mcap"};
    if (next_ == items_.size()) return std::optional<Due>();
    return std::optional(items_[next_].due);
  }
  ByteView take() override {
    // Allocates anew each time, so that use of a former payload shows under ASan.
    current_ = std::make_unique<std::string>(items_[next_++].payload);
    return bytesOf(*current_);
  }

  std::size_t fail_at = static_cast<std::size_t>(-1);

 private:
  std::vector<Item> items_;
  std::size_t next_ = 0;
  std::unique_ptr<std::string> current_;
};

/// Keeps what it is notified of.
class FakeJournal : public SendJournal {
 public:
  struct Line {
    Due due;
    SteadyTime deadline;
    SteadyTime sent_at;
  };
  void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) override {
    lines.push_back({due, deadline, sent_at});
    payloads.emplace_back(textOf(payload));
  }

  std::vector<Line> lines;
  std::vector<std::string> payloads;
};

}  // namespace rocinante::test
