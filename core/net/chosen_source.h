#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/net/passed_count.h"

namespace rocinante {

/// Another source without the datagrams that a judge of each does not want. A batch without any of
/// those passes through unchanged.
class ChosenSource : public DatagramSource {
 public:
  Result<std::span<const ReceivedDatagram>> receive() override;
  InputCounts counts() const override { return inner_->counts(); }
  std::optional<SubscriptionOutcome> subscription() const override {
    return inner_->subscription();
  }
  Account leftOut() const override;

  bool keepsPlace() const override { return inner_->keepsPlace(); }
  void confirm(std::uint64_t count) override { inner_->confirm(count_.receivedFor(count)); }
  std::uint64_t dropped() const override { return inner_->dropped(); }
  Result<std::uint64_t> droppedByNow() override { return inner_->droppedByNow(); }
  std::optional<std::string> maintain() override { return inner_->maintain(); }
  Nanoseconds deliveryDelay() const override { return inner_->deliveryDelay(); }
  bool ended() const override { return inner_->ended(); }
  int fileDescriptor() const override { return inner_->fileDescriptor(); }
  std::uint64_t receiveBufferBytes() const override { return inner_->receiveBufferBytes(); }
  std::string serverId() const override { return inner_->serverId(); }
  const Endpoint& endpoint() const override { return inner_->endpoint(); }
  const SocketAddress& boundAddress() const override { return inner_->boundAddress(); }

 protected:
  explicit ChosenSource(std::unique_ptr<DatagramSource> inner)
      : inner_(std::move(inner)), count_(inner_->keepsPlace()) {}

  /// Asked once for each datagram, in order; counts those that it does not want.
  virtual bool wants(const ReceivedDatagram& datagram) = 0;

 private:
  bool takes(const ReceivedDatagram& datagram);

  std::unique_ptr<DatagramSource> inner_;
  PassedCount count_;
  std::vector<ReceivedDatagram> taken_;
};

}  // namespace rocinante
