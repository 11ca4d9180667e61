#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>

#include "core/net/datagram_source.h"
#include "core/pcap/frame_reader.h"

namespace rocinante {

/// The datagrams of one receive(), with copies of their bytes.
class SeenBatch {
 public:
  static constexpr std::size_t kMaxDatagrams = 256;

  // Not initialised: pages that no datagram reaches cost nothing.
  SeenBatch() : bytes_(new std::byte[kMaxDatagrams * kMaxDatagramBytes]) {}

  void clear() { count_ = used_ = 0; }
  std::size_t size() const { return count_; }
  bool isFull() const { return count_ == kMaxDatagrams; }
  void add(const SeenDatagram& seen, WallTime time) {
    if (isFull()) return;
    std::byte* const payload = bytes_.get() + used_;
    if (!seen.payload.empty()) std::memcpy(payload, seen.payload.data(), seen.payload.size());
    used_ += seen.payload.size();
    destinations_[count_] = seen.destination;
    datagrams_[count_] = {
        {payload, seen.payload.size()}, seen.sender, time, seen.cut, &destinations_[count_]};
    ++count_;
  }
  std::span<const ReceivedDatagram> datagrams() const { return {datagrams_.data(), count_}; }

 private:
  static constexpr std::size_t kMaxDatagramBytes = 65'535;

  std::unique_ptr<std::byte[]> bytes_;
  std::size_t used_ = 0, count_ = 0;
  std::array<ReceivedDatagram, kMaxDatagrams> datagrams_{};
  std::array<SocketAddress, kMaxDatagrams> destinations_{};
};

}  // namespace rocinante
