#include "player/relay/relay_ports.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "core/relay/fan_out.h"

namespace rocinante {
namespace {

constexpr int kSendBufferBytes = 8 << 20;
constexpr int kRoomTurns = 2;  ///< of a millisecond, before the rest of a batch is dropped
/// Requests are answered between datagrams: a flood of them must not hold up what passes.
constexpr int kRequestBatches = 4;

}  // namespace

bool waitUntilWritable(int descriptor) {
  pollfd writable{descriptor, POLLOUT, 0};
  // A full device queue polls as writable at once, so only the timeout waits.
  const bool device_full = errno == ENOBUFS;
  return ::poll(&writable, device_full ? 0 : 1, 1) >= 0;
}

Result<std::unique_ptr<ServePort>> ServePort::open(const Endpoint& at,
                                                   SubscriptionDesk::Options options,
                                                   std::size_t signature_bytes) {
  if (at.isMulticast() || at.isPcap()) {
    return Error{ErrorKind::bad_argument, "--serve needs a unicast address: HOST:PORT or :PORT",
                 at.text()};
  }
  Result<UdpReceiver> socket = UdpReceiver::open(at);
  if (!socket) return socket.error();
  const int bytes = kSendBufferBytes;
  // As much as the system grants: what does not fit is counted.
  (void)::setsockopt(socket->fileDescriptor(), SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
  return std::unique_ptr<ServePort>(
      new ServePort(std::move(*socket), std::move(options), signature_bytes));
}

ServePort::ServePort(UdpReceiver socket, SubscriptionDesk::Options options,
                     std::size_t signature_bytes)
    : socket_(std::move(socket)),
      desk_(std::move(options)),
      signature_bytes_(signature_bytes),
      fan_out_(socket_.fileDescriptor()) {}

void ServePort::begin(const SocketAddress& from, const SubscriptionWish& wish, Relay& relay,
                      const RelayOutputOptions& defaults, LogTime now) {
  RelayOutputOptions options = defaults;
  RelayFilter filter;
  if (!wish.source.empty()) filter.sources = {wish.source};
  if (!wish.device.empty()) filter.devices = {wish.device};
  if (!wish.signal.empty()) filter.signals = {wish.signal};
  if (!wish.min_change.empty()) {
    MinChange least;
    (void)least.addAll(wish.min_change);  // readSubscription() has read it
    options.pacing.min_change.join(least);
  }
  if (!filter.passesEverything()) options.filters.push_back(std::move(filter));
  if (wish.rate_hz) {
    constexpr double kLongestSeconds = 3600;
    const double seconds = std::min(1 / *wish.rate_hz, kLongestSeconds);
    const Nanoseconds interval(static_cast<std::int64_t>(seconds * 1e9));
    auto& slowest = options.pacing.interval;
    slowest = std::max(slowest.value_or(Nanoseconds(0)), interval);
  }
  options.signature_bytes = signature_bytes_;
  options.head_bytes = (from.is_ipv6 ? 48 : 28) + signature_bytes_;
  const Relay::OutputId output = relay.open(std::move(options), now);
  by_address_[from.text()] = output;
  subscribers_.emplace(output, Subscriber{output, FanOut::Destination(from)});
  if (relay.isWhole(output)) whole_.push_back(output);
}

void ServePort::end(const SocketAddress& from, Relay& relay) {
  const auto found = by_address_.find(from.text());
  if (found == by_address_.end()) return;
  conflated_ += relay.conflated(found->second);
  filtered_out_ += relay.filteredOut(found->second);
  PacedCounts paced = relay.paced(found->second);
  paced.waiting = 0;
  paced_ += paced;
  relay.close(found->second);
  std::erase(whole_, found->second);
  subscribers_.erase(found->second);
  by_address_.erase(found);
}

Status ServePort::handleRequests(Relay& relay, const RelayOutputOptions& defaults, SteadyTime now,
                                 LogTime log_now) {
  using Change = SubscriptionDesk::Outcome::Change;
  for (int turn = 0; turn < kRequestBatches; ++turn) {
    const auto batch = socket_.receive();
    if (!batch) return batch.error();
    if (batch->empty()) break;
    for (const ReceivedDatagram& each : *batch) {
      const SubscriptionDesk::Outcome outcome = desk_.handle(each.payload, each.sender, now);
      if (!outcome.answer.empty()) {
        const FanOut::Destination to(each.sender);
        fan_out_.add(bytesOf(outcome.answer), to);
        fan_out_.flush([] { return false; });
      }
      const bool begins = outcome.change == Change::begun || outcome.change == Change::replaced;
      if (begins || outcome.change == Change::ended) end(each.sender, relay);
      if (begins) begin(each.sender, outcome.wish, relay, defaults, log_now);
      if (outcome.greet) relay.greet(by_address_.at(each.sender.text()));
    }
  }
  for (const SocketAddress& ended : desk_.expire(now)) end(ended, relay);
  return {};
}

std::uint64_t ServePort::conflated(const Relay& relay) const {
  std::uint64_t conflated = conflated_;
  for (const auto& each : subscribers_) conflated += relay.conflated(each.first);
  return conflated;
}

FilteredOutCounts ServePort::filteredOut(const Relay& relay) const {
  FilteredOutCounts counts = filtered_out_;
  for (const auto& each : subscribers_) counts += relay.filteredOut(each.first);
  return counts;
}

PacedCounts ServePort::paced(const Relay& relay) const {
  PacedCounts paced = paced_;
  for (const auto& each : subscribers_) paced += relay.paced(each.first);
  return paced;
}

bool ServePort::waitForRoom() { return waitUntilWritable(socket_.fileDescriptor()); }

void ServePort::flush() {
  int turns = 0;
  const FanOut::Outcome outcome =
      fan_out_.flush([&] { return ++turns <= kRoomTurns && waitForRoom(); });
  forwarded_ += outcome.sent;
  dropped_ += outcome.dropped;
}

void ServePort::send(std::span<const Relay::Outgoing> outgoing) {
  if (subscribers_.empty()) return;
  for (const Relay::Outgoing& each : outgoing) {
    if (each.output == Relay::kEveryWhole) {
      for (const Relay::OutputId id : whole_) {
        fan_out_.add(each.payload, subscribers_.at(id).address);
      }
    } else if (const auto to = subscribers_.find(each.output); to != subscribers_.end()) {
      fan_out_.add(each.payload, to->second.address);
    }
    if (fan_out_.full()) flush();
  }
  if (!fan_out_.empty()) flush();
}

void ToPort::send(std::span<const Relay::Outgoing> outgoing) {
  payloads.clear();
  for (const Relay::Outgoing& each : outgoing) {
    if (each.output == output || (whole && each.output == Relay::kEveryWhole)) {
      payloads.push_back(each.payload);
    }
  }
  if (payloads.empty()) return;
  int turns = 0;
  SendOutcome outcome = sendInOrder(*sink, payloads, [&] {
    return ++turns <= kRoomTurns && waitUntilWritable(sink->fileDescriptor());
  });
  forwarded += outcome.sent;
  dropped += outcome.dropped;
  if (outcome.trouble && !trouble) trouble = std::move(outcome.trouble);
}

}  // namespace rocinante
