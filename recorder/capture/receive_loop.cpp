#include "recorder/capture/receive_loop.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

// One endpoint under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 64;
// Draining and sleeping costs half as much as waking for each datagram, and takes 600,000 a second.
constexpr Nanoseconds kPause = std::chrono::microseconds(500);
constexpr Nanoseconds kIdlePause = std::chrono::milliseconds(2);
constexpr int kIdlePasses = 200;
// Few wake-ups for the writing thread, and still well within the reordering window.
constexpr Nanoseconds kBlockAge = std::chrono::milliseconds(5);
constexpr Nanoseconds kAskForDrops = std::chrono::milliseconds(50);
constexpr Nanoseconds kRateSpan = std::chrono::seconds(1);
// A continuing flood must not keep a recording from ending.
constexpr Nanoseconds kLastPasses = std::chrono::milliseconds(500);

}  // namespace

ReceiveLoop::ReceiveLoop(std::vector<DatagramSource*> sources, Look look, HandOver& out,
                         Callbacks callbacks)
    : look_(std::move(look)), out_(out), callbacks_(std::move(callbacks)), clock_(look_()) {
  for (DatagramSource* source : sources) {
    Listener listener{};
    listener.source = source;
    listener.checked = listener.rate_since = clock_.now();
    listeners_.push_back(listener);
  }
  begins_ = asked_ = clock_.now();
}

Nanoseconds ReceiveLoop::pauseAfter(bool moved) {
  idle_passes_ = moved ? 0 : std::min(idle_passes_ + 1, kIdlePasses);
  return idle_passes_ == kIdlePasses ? kIdlePause : kPause;
}

void ReceiveLoop::lookAgain() {
  if (const std::optional<ClockStep> step = clock_.observe(look_())) steps_.push_back(*step);
}

Result<bool> ReceiveLoop::pass() {
  lookAgain();
  bool busy = false;
  for (std::uint32_t endpoint = 0; endpoint < listeners_.size(); ++endpoint) {
    const Result<bool> received = drain(endpoint);
    if (!received) return received.error();
    busy = busy || *received;
  }
  if (clock_.now() - asked_ >= kAskForDrops) {
    if (Status asked = askForDrops(); !asked) return asked.error();
  }
  LogTime drained_until = clock_.now();
  for (const Listener& each : listeners_) {
    drained_until = std::min(drained_until, each.drained_until);
  }
  // `drained_until` must not overtake a block that is still held back.
  if (!block_) {
    out_.give(nullptr, losses_, steps_, drained_until);
  } else if (clock_.now() - block_began_ >= kBlockAge) {
    handOverBlock(drained_until);
  }
  return busy;
}

Result<bool> ReceiveLoop::drain(std::uint32_t endpoint) {
  Listener& listener = listeners_[endpoint];
  bool received = false;
  for (int turn = 0; turn < kBatchesATurn; ++turn) {
    const LogTime asked = clock_.now();
    const auto batch = listener.source->receive();
    if (!batch) return batch.error();
    if (batch->empty()) {
      listener.drained_until = asked - listener.source->deliveryDelay();
      break;
    }
    received = true;
    if (callbacks_.tee) callbacks_.tee(*batch);
    listener.datagrams += batch->size();
    // Read the clocks now, so that no timestamp of the batch is later than the last reading.
    lookAgain();
    for (const ReceivedDatagram& datagram : *batch) keep(endpoint, datagram);
    listener.drained_until = listener.last;
  }
  noteDrops(endpoint, listener.source->dropped());
  return received;
}

void ReceiveLoop::keep(std::uint32_t endpoint, const ReceivedDatagram& datagram) {
  Listener& listener = listeners_[endpoint];
  listener.last = std::max(listener.last, clock_.at(datagram.kernel_time));
  const LogTime time = listener.last;
  listener.bytes += datagram.payload.size();
  const auto add = [&] {
    return block_ && block_->add(endpoint, time, datagram.sender, datagram.payload,
                                 datagram.destination, datagram.subject);
  };
  bool kept = add();
  if (!kept) {
    if (block_) handOverBlock(std::nullopt);
    block_ = out_.freeBlock();
    block_began_ = clock_.now();
    kept = add();
  }
  if (kept && !datagram.truncated) return;
  EndpointLoss loss{endpoint, time, time, {}};
  (kept ? loss.counts.truncated : loss.counts.queue) = 1;
  addLoss(losses_, loss);
}

void ReceiveLoop::noteDrops(std::uint32_t endpoint, std::uint64_t dropped) {
  Listener& listener = listeners_[endpoint];
  if (dropped > listener.dropped) {
    EndpointLoss loss{endpoint, listener.checked, clock_.now(), {}};
    loss.counts.kernel = dropped - listener.dropped;
    addLoss(losses_, loss);
    listener.dropped = dropped;
  }
  listener.checked = clock_.now();
}

Status ReceiveLoop::askForDrops() {
  asked_ = clock_.now();
  for (std::uint32_t endpoint = 0; endpoint < listeners_.size(); ++endpoint) {
    const Result<std::uint64_t> dropped = listeners_[endpoint].source->droppedByNow();
    if (!dropped) return dropped.error();
    noteDrops(endpoint, *dropped);
    maintain(listeners_[endpoint]);
  }
  return {};
}

void ReceiveLoop::maintain(Listener& listener) {
  if (const auto news = listener.source->maintain(); news && callbacks_.note)
    callbacks_.note(*news);
  if (clock_.now() - listener.rate_since >= kRateSpan) measureRate(listener);
}

void ReceiveLoop::measureRate(Listener& listener) {
  const double seconds = std::chrono::duration<double>(clock_.now() - listener.rate_since).count();
  ReceiveRate rate;
  rate.datagrams_a_second = static_cast<double>(listener.datagrams) / seconds;
  if (listener.datagrams > 0) {
    rate.bytes_a_datagram =
        static_cast<double>(listener.bytes) / static_cast<double>(listener.datagrams);
  }
  listener.datagrams = listener.bytes = 0;
  listener.rate_since = clock_.now();
  if (neededReceiveBuffer(rate) > neededReceiveBuffer(listener.busiest)) listener.busiest = rate;
  if (listener.small_buffer_reported || !callbacks_.note) return;
  const auto advice =
      receiveBufferAdvice(boundText(*listener.source), listener.source->receiveBufferBytes(), rate);
  if (!advice) return;
  listener.small_buffer_reported = true;
  callbacks_.note(*advice);
}

Nanoseconds ReceiveLoop::deliveryDelay() const {
  Nanoseconds longest{0};
  for (const Listener& each : listeners_) longest = std::max(longest, each.source->deliveryDelay());
  return longest;
}

void ReceiveLoop::handOverBlock(std::optional<LogTime> drained_until) {
  out_.give(std::move(block_), losses_, steps_, drained_until);
}

Status ReceiveLoop::finish() {
  Status ended;
  const LogTime stopped = clock_.now();
  for (bool busy = true; busy && clock_.now() - stopped < kLastPasses;) {
    const Result<bool> passed = pass();
    if (!passed) ended = passed.error();
    busy = passed && *passed;
  }
  if (Status asked = askForDrops(); ended && !asked) ended = asked;
  handOverBlock(clock_.now());
  out_.finish();
  return ended;
}

}  // namespace rocinante
