#include "recorder/capture/tee.h"

#include <algorithm>
#include <utility>

#include "core/net/local_address.h"
#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kFull = std::chrono::milliseconds(1);

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

}  // namespace

Result<std::unique_ptr<Tee>> Tee::open(const Endpoint& to, const Options& options) {
  Result<UdpSender> sender = UdpSender::open(to);
  if (!sender) return sender.error();
  return std::unique_ptr<Tee>(new Tee(std::move(*sender), options));
}

Tee::Tee(UdpSender sender, const Options& options) : sender_(std::move(sender)), options_(options) {
  account_.to = sender_.endpoint();
  thread_ = threadWithoutSignals("tee", [this] { run(); });
}

Tee::~Tee() { close(); }

void Tee::close() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closed_ = steadyNow();
  }
  news_.notify_one();
  thread_.join();
}

Tee::Account Tee::account() const {
  const std::lock_guard lock(mutex_);
  return account_;
}

void Tee::forward(std::span<const ReceivedDatagram> batch) {
  if (batch.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    for (const ReceivedDatagram& each : batch) {
      const auto add = [&] {
        return !waiting_.empty() && waiting_.back()->add(0, {}, each.sender, each.payload);
      };
      if (add()) continue;
      if (free_.empty() && made_ < options_.queue_blocks) {
        free_.push_back(std::make_unique<DatagramBlock>());
        ++made_;
      }
      if (!free_.empty()) {
        waiting_.push_back(std::move(free_.back()));
        free_.pop_back();
      }
      if (!add()) ++account_.dropped;
    }
  }
  news_.notify_one();
}

/// Takes all waiting blocks. False when none are left and none will come.
bool Tee::take(std::vector<std::unique_ptr<DatagramBlock>>& blocks) {
  std::unique_lock lock(mutex_);
  for (auto& each : blocks) {
    each->clear();
    free_.push_back(std::move(each));
  }
  blocks.clear();
  news_.wait(lock, [&] { return !waiting_.empty() || closed_; });
  std::swap(blocks, waiting_);
  return !blocks.empty();
}

void Tee::run() {
  std::vector<std::unique_ptr<DatagramBlock>> blocks;
  while (take(blocks)) {
    for (const auto& each : blocks) send(*each);
  }
}

bool Tee::mayWait() {
  const std::lock_guard lock(mutex_);
  return !closed_ || steadyNow() - *closed_ < options_.patience;
}

void Tee::send(const DatagramBlock& block) {
  payloads_.clear();
  for (const Arrival& each : block.arrivals()) payloads_.push_back(block.payload(each));
  std::span<const ByteView> left(payloads_);
  std::uint64_t refused = 0;
  std::optional<Error> trouble;
  while (!left.empty()) {
    const Result<std::size_t> sent = sender_.sendWithoutWaiting(left);
    if (sent && *sent == 0) {
      if (!mayWait()) break;
      std::this_thread::sleep_for(kFull);
      continue;
    }
    if (!sent) {
      ++refused;
      if (!trouble) trouble = sent.error();
    }
    left = left.subspan(sent ? *sent : 1);
  }
  const std::lock_guard lock(mutex_);
  account_.sent += payloads_.size() - left.size() - refused;
  account_.dropped += left.size() + refused;
  if (trouble && !account_.trouble) account_.trouble = std::move(trouble);
}

Status checkTee(const Endpoint& to, const std::vector<DatagramSource*>& sources) {
  for (const DatagramSource* source : sources) {
    const SocketAddress& bound = source->boundAddress();
    // Watched traffic includes the tee's own, which is recognised by its source address.
    if (source->endpoint().isPcap() || bound.port != to.address.port ||
        bound.is_ipv6 != to.address.is_ipv6) {
      continue;
    }
    const bool same_interface = to.interface.empty() || source->endpoint().interface.empty() ||
                                to.interface == source->endpoint().interface;
    const bool hears = bound.isAny() ? to.isMulticast() || isLocalAddress(to.address)
                                     : bound.address == to.address.address && same_interface;
    if (hears) {
      return Error{ErrorKind::bad_argument,
                   "--tee would send to " + boundText(*source) +
                       ", where this recorder listens: it would receive itself endlessly",
                   to.text()};
    }
  }
  return {};
}

}  // namespace rocinante
