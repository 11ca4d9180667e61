#include "core/subscription/subscribed_source.h"

#include <chrono>
#include <utility>

#include "core/base/random_id.h"

namespace rocinante {
namespace {

// As in ChosenSource: a flood must not look like silence, nor keep the caller for ever.
constexpr int kBatches = 16;

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

}  // namespace

Result<SubscribedSource> SubscribedSource::open(const Endpoint& endpoint,
                                                const UdpReceiver::Options& options, Judge judge) {
  if (!endpoint.isSubscription()) {
    return Error{ErrorKind::bad_argument, "not a subscribe:// endpoint", endpoint.text()};
  }
  Endpoint local;
  local.address.is_ipv6 = endpoint.address.is_ipv6;
  Result<UdpReceiver> receiver = UdpReceiver::open(local, options);
  if (!receiver) return receiver.error();
  SubscribedSource source(endpoint, std::move(*receiver), std::move(judge));
  source.ask(steadyNow());
  return source;
}

SubscribedSource::SubscribedSource(const Endpoint& endpoint, UdpReceiver receiver, Judge judge)
    : endpoint_(endpoint),
      receiver_(std::make_unique<UdpReceiver>(std::move(receiver))),
      client_(endpoint, randomNumber, steadyNow()),
      judge_(std::move(judge)) {
  if (judge_) counts_.untrusted.emplace();
}

SubscribedSource::~SubscribedSource() {
  if (!receiver_) return;
  // Sent once: a lease that is not ended runs out.
  if (const auto leave = client_.leave()) {
    (void)receiver_->sendTo(endpoint_.address, bytesOf(*leave));
  }
}

void SubscribedSource::ask(SteadyTime now) {
  const std::optional<std::string> request = client_.nextRequest(now);
  if (!request) return;
  const Status sent = receiver_->sendTo(endpoint_.address, bytesOf(*request));
  trouble_ = sent ? std::nullopt : std::optional(sent.error().what);
}

/// Only what comes from the relay is judged: a stranger's copy must not make it a repetition.
bool SubscribedSource::isTrusted(const ReceivedDatagram& datagram) {
  if (!judge_ || datagram.sender != endpoint_.address) return true;
  const std::optional<Untrusted> reason = judge_(datagram.payload, datagram.kernel_time);
  if (!reason) return true;
  counts_.untrusted->add(*reason);
  client_.noteUntrusted(datagram.payload, *reason);
  return false;
}

bool SubscribedSource::takes(SteadyTime now, const ReceivedDatagram& datagram) {
  if (!isTrusted(datagram)) return false;
  switch (client_.take(now, datagram.sender, datagram.payload)) {
    case SubscriptionClient::Arrival::traffic:
      return true;
    case SubscriptionClient::Arrival::answer:
      break;
    case SubscriptionClient::Arrival::ignored:
      ++counts_.requests;
      break;
    case SubscriptionClient::Arrival::stranger:
      ++counts_.strangers;
      break;
  }
  return false;
}

Result<std::span<const ReceivedDatagram>> SubscribedSource::receive() {
  const SteadyTime now = steadyNow();
  taken_.clear();
  for (int turn = 0; turn < kBatches && taken_.empty(); ++turn) {
    const auto batch = receiver_->receive();
    if (!batch) return batch;
    if (batch->empty()) break;
    for (const ReceivedDatagram& each : *batch) {
      if (takes(now, each)) taken_.push_back(each);
    }
  }
  ask(now);
  return std::span<const ReceivedDatagram>(taken_);
}

std::optional<SubscriptionOutcome> SubscribedSource::subscription() const {
  SubscriptionOutcome outcome = client_.outcome();
  if (!outcome.accepted_after && trouble_) outcome.trouble += " (" + *trouble_ + ")";
  return outcome;
}

std::optional<std::string> SubscribedSource::maintain() {
  ask(steadyNow());
  std::optional<std::string> news = client_.takeNews();
  if (news && trouble_) *news += " (" + *trouble_ + ")";
  return news;
}

}  // namespace rocinante
