#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// A datagram in a DatagramBlock.
struct Arrival {
  LogTime time;
  SocketAddress sender;
  std::uint32_t endpoint = 0;  ///< index of the listening endpoint
  std::uint32_t offset = 0;    ///< of the payload in the block
  std::uint32_t length = 0;
  bool has_destination = false;      ///< it was not sent to the endpoint's own address
  std::uint16_t subject_length = 0;  ///< of its NATS subject; 0: none, as usual
};

/// Many datagrams in one block of memory, handed from the receiving thread to the writing one.
/// Of one size and reused: receiving allocates nothing per datagram. Only a message of a server may
/// be larger; such a block has that one alone.
class DatagramBlock {
 public:
  static constexpr std::size_t kBytes = std::size_t{512} << 10U;
  static constexpr std::size_t kArrivals = 8192;

  DatagramBlock() : bytes_(std::make_unique_for_overwrite<std::byte[]>(kBytes)) {
    arrivals_.reserve(kArrivals);
  }

  /// Whether one more datagram of this size fits, including its destination.
  bool hasRoom(std::size_t bytes) const {
    return arrivals_.size() < kArrivals && bytes <= capacity_ - used_;
  }
  /// Copies the datagram in. False when it does not fit; an empty block takes any datagram.
  /// `destination` is null when it is the endpoint's own address, as usual. A subject is cut to
  /// 65,535 bytes.
  bool add(std::uint32_t endpoint, LogTime time, const SocketAddress& sender, ByteView payload,
           const SocketAddress* destination = nullptr, std::string_view subject = {}) {
    const std::size_t before = destination != nullptr ? sizeof *destination : 0;
    subject = subject.substr(0, std::numeric_limits<std::uint16_t>::max());
    const std::size_t needed = payload.size() + before + subject.size();
    if (arrivals_.empty() && needed > capacity_) allocate(needed);
    if (!hasRoom(needed)) return false;
    if (!subject.empty()) {
      std::memcpy(bytes_.get() + used_, subject.data(), subject.size());
      used_ += subject.size();
    }
    if (destination != nullptr) {
      // Stored only when needed, before the payload: it is almost always the same.
      std::memcpy(bytes_.get() + used_, destination, before);
      used_ += before;
    }
    if (!payload.empty()) std::memcpy(bytes_.get() + used_, payload.data(), payload.size());
    arrivals_.push_back({time, sender, endpoint, static_cast<std::uint32_t>(used_),
                         static_cast<std::uint32_t>(payload.size()), destination != nullptr,
                         static_cast<std::uint16_t>(subject.size())});
    used_ += payload.size();
    return true;
  }

  bool empty() const { return arrivals_.empty(); }
  std::span<const Arrival> arrivals() const { return arrivals_; }
  ByteView payload(const Arrival& arrival) const {
    return {bytes_.get() + arrival.offset, arrival.length};
  }
  std::optional<SocketAddress> destination(const Arrival& arrival) const {
    return destinationOf(arrival, payload(arrival));
  }
  /// The same for a payload that is in its block.
  static std::optional<SocketAddress> destinationOf(const Arrival& arrival, ByteView payload) {
    if (!arrival.has_destination) return std::nullopt;
    SocketAddress destination;
    std::memcpy(&destination, payload.data() - sizeof destination, sizeof destination);
    return destination;
  }
  /// The subject of a payload that is in its block.
  static std::string_view subjectOf(const Arrival& arrival, ByteView payload) {
    const std::size_t behind = arrival.has_destination ? sizeof(SocketAddress) : 0;
    return {reinterpret_cast<const char*>(payload.data()) - behind - arrival.subject_length,
            arrival.subject_length};
  }
  void clear() {
    arrivals_.clear();
    used_ = 0;
    if (capacity_ > kBytes) allocate(kBytes);
  }

 private:
  void allocate(std::size_t bytes) {
    bytes_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
    capacity_ = bytes;
  }

  std::size_t capacity_ = kBytes;
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t used_ = 0;
  std::vector<Arrival> arrivals_;
};

}  // namespace rocinante
