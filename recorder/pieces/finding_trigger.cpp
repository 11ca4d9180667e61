#include "recorder/pieces/finding_trigger.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
namespace {

/// What an item takes beside its payload.
constexpr std::size_t kItemBytes = 64;

WatchOptions watchOptions(Severity severity) {
  WatchOptions options;
  options.least = options.fail_on = severity;
  return options;
}

}  // namespace

void FindingTrigger::Queue::clear() {
  items.clear();
  payloads.clear();
  losses.clear();
  reached.reset();
}

FindingTrigger::FindingTrigger(Cell cell, Severity severity, bool is_live)
    : cell_(std::move(cell)), watch_(cell_, watchOptions(severity)), is_live_(is_live) {
  if (is_live_) thread_ = threadWithoutSignals("watch", [this] { work(); });
}

FindingTrigger::~FindingTrigger() { finish(); }

void FindingTrigger::add(LogTime time, std::string_view encoding, bool captured,
                         ByteView datagram) {
  add({time, std::string(encoding), captured, false, datagram.size()}, datagram);
}

void FindingTrigger::addMade(LogTime time, std::string_view encoding, ByteView made) {
  add({time, std::string(encoding), true, true, made.size()}, made);
}

void FindingTrigger::add(Queued item, ByteView payload) {
  if (!is_live_) return judge(item, payload);
  const std::lock_guard lock(mutex_);
  const std::size_t held = queue_.payloads.size() + kItemBytes * queue_.items.size();
  if (held + payload.size() + kItemBytes > kMaxQueuedBytes) {
    ++dropped_;
    return;
  }
  queue_.items.push_back(std::move(item));
  queue_.payloads.insert(queue_.payloads.end(), payload.begin(), payload.end());
}

void FindingTrigger::addLoss(const LossSpan& span) {
  if (!is_live_) return watch_.addLoss(span);
  const std::lock_guard lock(mutex_);
  queue_.losses.push_back(span);
}

void FindingTrigger::reach(LogTime moment) {
  if (!is_live_) return passTo(moment);
  // The thread is woken a few times per update, not for each datagram.
  if (reached_ && moment - *reached_ < FindingWatch::kPeriod / 4) return;
  reached_ = moment;
  {
    const std::lock_guard lock(mutex_);
    queue_.reached = moment;
  }
  given_.notify_one();
}

std::vector<FindingTrigger::Begun> FindingTrigger::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(begun_, {});
}

void FindingTrigger::finish() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_finished_ = true;
  }
  given_.notify_one();
  thread_.join();
}

void FindingTrigger::work() {
  Queue taken;
  for (bool is_last = false; !is_last;) {
    {
      std::unique_lock lock(mutex_);
      given_.wait(lock, [&] { return is_finished_ || queue_.reached; });
      is_last = is_finished_;
      std::swap(taken, queue_);
    }
    judge(taken);
    // Its memory serves again.
    taken.clear();
  }
}

void FindingTrigger::judge(const Queue& queue) {
  for (const LossSpan& loss : queue.losses) watch_.addLoss(loss);
  std::size_t at = 0;
  for (const Queued& each : queue.items) {
    judge(each, ByteView(queue.payloads).subspan(at, each.bytes));
    at += each.bytes;
  }
  if (queue.reached) passTo(*queue.reached);
}

void FindingTrigger::judge(const Queued& item, ByteView payload) {
  passTo(item.time);
  if (!item.made) return watch_.add(item.time, item.encoding, item.captured, payload);
  watch_.addOctets(item.time, item.encoding, true);
  watch_.add(item.time, "rk1", false, payload);
}

void FindingTrigger::passTo(LogTime now) {
  // The clock that reach() tells is never before a datagram that was added.
  if (passed_) now = std::max(now, *passed_);
  passed_ = now;
  for (const FindingChange& change : watch_.reach(now)) {
    // The cell's own faults, which have no time, are none of the session's.
    if (!change.begins || !change.finding.first) continue;
    const std::lock_guard lock(mutex_);
    begun_.push_back({change.at, fmt::format("{} [{}]", change.finding.text, change.finding.rule)});
  }
}

}  // namespace rocinante
