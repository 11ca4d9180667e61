#pragma once

#include <functional>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "core/subscription/subscription_client.h"

namespace rocinante {

/// What a relay sends to a subscriber (subscribe://), received on a UDP port that the system chose.
/// receive() and maintain() both keep the subscription, so that it is kept under constant traffic
/// and in silence; maintain() says when the relay stops to answer, refuses, accepts or has been
/// restarted. RKS1 lines are never passed on, nor is anything from another address than the
/// relay's. With a judge, neither is what it refuses, and only answers that it accepts are obeyed.
/// The end of its life ends the lease. One thread.
class SubscribedSource final : public DatagramSource {
 public:
  /// Why a datagram that was received at this time is not trusted (TrustJudge); empty: it is.
  using Judge = std::function<std::optional<Untrusted>(ByteView, WallTime)>;

  /// Asks at once and does not wait for the answer. Without a judge everything from the relay's
  /// address is trusted. refused as in UdpReceiver::open; bad_argument for another scheme than
  /// subscribe://.
  static Result<SubscribedSource> open(const Endpoint& endpoint,
                                       const UdpReceiver::Options& options = {}, Judge judge = {});

  ~SubscribedSource() override;
  SubscribedSource(SubscribedSource&&) noexcept = default;
  SubscribedSource& operator=(SubscribedSource&&) = delete;

  Result<std::span<const ReceivedDatagram>> receive() override;
  InputCounts counts() const override { return counts_; }
  std::optional<SubscriptionOutcome> subscription() const override;
  std::optional<std::string> maintain() override;

  std::uint64_t dropped() const override { return receiver_->dropped(); }
  Result<std::uint64_t> droppedByNow() override { return receiver_->droppedByNow(); }
  int fileDescriptor() const override { return receiver_->fileDescriptor(); }
  std::uint64_t receiveBufferBytes() const override { return receiver_->receiveBufferBytes(); }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return receiver_->boundAddress(); }

  bool isSubscribed() const { return client_.isSubscribed(); }

 private:
  SubscribedSource(const Endpoint& endpoint, UdpReceiver receiver, Judge judge);
  bool isTrusted(const ReceivedDatagram& datagram);
  bool takes(SteadyTime now, const ReceivedDatagram& datagram);
  void ask(SteadyTime now);

  Endpoint endpoint_;
  std::unique_ptr<UdpReceiver> receiver_;  ///< null when moved from
  SubscriptionClient client_;
  Judge judge_;
  InputCounts counts_;
  std::vector<ReceivedDatagram> taken_;
  std::optional<std::string> trouble_;  ///< why the last request could not be sent
};

}  // namespace rocinante
