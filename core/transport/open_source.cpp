#include "core/transport/open_source.h"

#include <utility>

#include "core/nats/jetstream_source.h"
#include "core/nats/nats_source.h"
#include "core/net/filtered_source.h"
#include "core/pcap/pcap_source.h"
#include "core/signing/trust_judge.h"
#include "core/subscription/subscribed_source.h"
#include "core/subscription/subscription_text.h"

namespace rocinante {
namespace {

Result<std::unique_ptr<DatagramSource>> openUnfiltered(const Endpoint& endpoint,
                                                       const InputOptions& options) {
  if (endpoint.isPcap()) {
    PcapOptions watching;
    watching.buffer_bytes = options.receiving.receive_buffer_bytes;
    return openPcap(endpoint, watching);
  }
  if (endpoint.isSubscription()) {
    SubscribedSource::Judge judge;
    if (options.trust) {
      judge = [trust = options.trust](ByteView datagram, WallTime received) {
        return trust->judge(datagram, received);
      };
    }
    auto subscribed = SubscribedSource::open(endpoint, options.receiving, std::move(judge));
    if (!subscribed) return subscribed.error();
    return std::make_unique<SubscribedSource>(std::move(*subscribed));
  }
  if (endpoint.scheme == Endpoint::Scheme::jetstream) {
    return openJetStream(endpoint,
                         options.resuming ? StreamReading::resuming : StreamReading::passing);
  }
  if (endpoint.isNats()) return openNatsSource(endpoint, {});
  Result<UdpReceiver> receiver = UdpReceiver::open(endpoint, options.receiving);
  if (!receiver) return receiver.error();
  return std::make_unique<UdpReceiver>(std::move(*receiver));
}

}  // namespace

Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint,
                                                   const InputOptions& options) {
  if (endpoint.isNats() && !options.allow.empty()) {
    return Error{ErrorKind::bad_argument,
                 "--allow is about senders' addresses, which a NATS server does not tell: let the "
                 "server's permissions say who may publish",
                 endpoint.text()};
  }
  auto source = openUnfiltered(endpoint, options);
  if (!source) return source;
  source = std::make_unique<FilteredSource>(std::move(*source), options.allow, options.own,
                                            &isSubscriptionText);
  // A subscription judges for itself: the relay's answers too.
  if (options.trust && !endpoint.isSubscription()) {
    source = std::make_unique<TrustedSource>(std::move(*source), options.trust);
  }
  return source;
}

Result<Sources> openSources(const std::vector<Endpoint>& endpoints, const InputOptions& options) {
  Sources sources;
  for (const Endpoint& each : endpoints) {
    if (each.hasOwnTimes() && endpoints.size() > 1) {
      const std::string what = each.isNats() ? "a stream" : "a capture file";
      return Error{ErrorKind::bad_argument,
                   what + " must be the only endpoint: its times are not those of live traffic",
                   each.text()};
    }
    auto source = openSource(each, options);
    if (!source) return source.error();
    sources.push_back(std::move(*source));
  }
  return sources;
}

}  // namespace rocinante
