#include "recorder/capture/tee.h"

#include <utility>

#include "core/net/hears.h"
#include "core/net/udp_socket.h"
#include "core/relay/fan_out.h"
#include "core/transport/open_sink.h"
#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kFull = std::chrono::milliseconds(1);

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

}  // namespace

Result<std::unique_ptr<Tee>> Tee::open(const Endpoint& to, const Options& options) {
  auto sink = openSink(to);
  if (!sink) return sink.error();
  return std::unique_ptr<Tee>(new Tee(std::move(*sink), options));
}

Tee::Tee(std::unique_ptr<DatagramSink> sink, const Options& options)
    : sink_(std::move(sink)), options_(options) {
  account_.to = sink_->endpoint();
  if (const auto* const socket = dynamic_cast<const UdpSender*>(sink_.get())) {
    local_address_ = socket->localAddress();
  }
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
  const Status flushed = sink_->flush();
  const std::lock_guard lock(mutex_);
  if (!flushed && !account_.trouble) account_.trouble = flushed.error();
}

bool Tee::mayWait() {
  const std::lock_guard lock(mutex_);
  return !closed_ || steadyNow() - *closed_ < options_.patience;
}

void Tee::send(const DatagramBlock& block) {
  payloads_.clear();
  for (const Arrival& each : block.arrivals()) payloads_.push_back(block.payload(each));
  SendOutcome outcome = sendInOrder(*sink_, payloads_, [this] {
    if (!mayWait()) return false;
    std::this_thread::sleep_for(kFull);
    return true;
  });
  const std::lock_guard lock(mutex_);
  account_.sent += outcome.sent;
  account_.dropped += outcome.dropped;
  if (outcome.trouble && !account_.trouble) account_.trouble = std::move(outcome.trouble);
}

Status checkTee(const Endpoint& to, const std::vector<DatagramSource*>& sources,
                const std::string& to_server) {
  for (const DatagramSource* source : sources) {
    const SocketAddress& bound = source->boundAddress();
    // Any program of this machine may have joined the group; then this socket gets it too.
    const bool may_hear = to.isMulticast() && bound.isAny() && bound.port == to.address.port &&
                          bound.is_ipv6 == to.address.is_ipv6 && !source->endpoint().isPcap();
    if (!may_hear && !hears(*source, to, to_server)) continue;
    return Error{ErrorKind::bad_argument,
                 "--tee would send to " + boundText(*source) +
                     ", where this recorder listens: it would receive itself endlessly",
                 to.text()};
  }
  return {};
}

}  // namespace rocinante
