#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/net/address_filter.h"
#include "core/net/chosen_source.h"

namespace rocinante {

/// A source without the datagrams of senders that are not allowed, those that this program itself
/// sent, and the requests that are meant for a relay; all are counted.
class FilteredSource final : public ChosenSource {
 public:
  using IsRequest = bool (*)(ByteView datagram);

  /// `is_request` may be null: no datagram is one.
  FilteredSource(std::unique_ptr<DatagramSource> inner, AddressFilter allow,
                 std::vector<SocketAddress> own, IsRequest is_request = nullptr)
      : ChosenSource(std::move(inner)),
        allow_(std::move(allow)),
        own_(std::move(own)),
        is_request_(is_request) {}

  InputCounts counts() const override;

 private:
  bool accepts(const ReceivedDatagram& datagram) override;

  AddressFilter allow_;
  std::vector<SocketAddress> own_;
  IsRequest is_request_;
  std::uint64_t refused_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t echoes_ = 0;
};

}  // namespace rocinante
