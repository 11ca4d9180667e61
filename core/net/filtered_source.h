#pragma once

#include <memory>
#include <vector>

#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"

namespace rocinante {

/// A source without the datagrams of senders that are not allowed and without those that this
/// program itself sent; both are counted. A batch without either passes through unchanged.
class FilteredSource final : public DatagramSource {
 public:
  FilteredSource(std::unique_ptr<DatagramSource> inner, AddressFilter allow,
                 std::vector<SocketAddress> own)
      : inner_(std::move(inner)), allow_(std::move(allow)), own_(std::move(own)) {}

  Result<std::span<const ReceivedDatagram>> receive() override;
  InputCounts counts() const override;

  std::uint64_t dropped() const override { return inner_->dropped(); }
  Result<std::uint64_t> droppedByNow() override { return inner_->droppedByNow(); }
  std::optional<std::string> maintain() override { return inner_->maintain(); }
  Nanoseconds deliveryDelay() const override { return inner_->deliveryDelay(); }
  bool ended() const override { return inner_->ended(); }
  int fileDescriptor() const override { return inner_->fileDescriptor(); }
  std::uint64_t receiveBufferBytes() const override { return inner_->receiveBufferBytes(); }
  const Endpoint& endpoint() const override { return inner_->endpoint(); }
  const SocketAddress& boundAddress() const override { return inner_->boundAddress(); }

 private:
  bool takes(const ReceivedDatagram& datagram);

  std::unique_ptr<DatagramSource> inner_;
  AddressFilter allow_;
  std::vector<SocketAddress> own_;
  std::vector<ReceivedDatagram> taken_;
  std::uint64_t refused_ = 0;
  std::uint64_t echoes_ = 0;
};

}  // namespace rocinante
