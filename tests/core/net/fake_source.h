#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "core/net/datagram_source.h"

namespace rocinante::test {

/// A socket that a test fills: batches of datagrams, drops, a failure.
class FakeSource final : public DatagramSource {
 public:
  explicit FakeSource(std::string_view endpoint)
      : endpoint_(Endpoint::parse(endpoint).value()), bound_(endpoint_.address) {}

  struct Datagram {
    std::string payload;
    WallTime stamp;
    std::string_view sender = "10.0.0.1";
    std::uint16_t port = 5000;
    bool truncated = false;
  };

  /// Adds one batch: the result of one receive().
  void arrive(std::vector<Datagram> batch) { waiting_.push_back(std::move(batch)); }
  /// Kernel drops: known with the next datagram, or only when queried.
  void drop(std::uint64_t count, bool only_when_asked = false) {
    dropped_by_now_ += count;
    if (!only_when_asked) dropped_ = dropped_by_now_;
  }
  void fail() { failed_ = true; }
  /// Behaves like a stream; confirmed() is what confirm() said last.
  void keepPlace() { keeps_place_ = true; }
  std::uint64_t confirmed() const { return confirmed_; }
  /// From here on everything has this destination, as in watched traffic.
  void watch(const SocketAddress& destination) { destination_ = destination; }
  /// Ends like a capture file: after the waiting datagrams nothing more arrives.
  void end() { ends_ = true; }
  void holdBack(Nanoseconds time) { held_back_ = time; }
  void grantBuffer(std::uint64_t bytes) { buffer_bytes_ = bytes; }
  /// The result of the next maintain().
  void mend(std::string sentence) { mended_ = std::move(sentence); }

  Result<std::span<const ReceivedDatagram>> receive() override {
    if (failed_) return Error{ErrorKind::refused, "cannot receive: the cable is out", "fake"};
    received_.clear();
    if (waiting_.empty()) return std::span<const ReceivedDatagram>();
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    for (const Datagram& each : current_) {
      received_.push_back({bytesOf(each.payload),
                           SocketAddress::parse(each.sender, each.port).value(), each.stamp,
                           each.truncated, destination_ ? &*destination_ : nullptr});
    }
    return std::span<const ReceivedDatagram>(received_);
  }
  std::uint64_t dropped() const override { return dropped_; }
  Result<std::uint64_t> droppedByNow() override { return dropped_ = dropped_by_now_; }
  std::optional<std::string> maintain() override { return std::exchange(mended_, std::nullopt); }
  bool keepsPlace() const override { return keeps_place_; }
  void confirm(std::uint64_t count) override { confirmed_ = count; }
  bool ended() const override { return ends_ && waiting_.empty(); }
  Nanoseconds deliveryDelay() const override { return held_back_; }
  std::uint64_t receiveBufferBytes() const override { return buffer_bytes_; }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return bound_; }

 private:
  Endpoint endpoint_;
  SocketAddress bound_;
  std::deque<std::vector<Datagram>> waiting_;
  std::vector<Datagram> current_;
  std::vector<ReceivedDatagram> received_;
  std::uint64_t dropped_ = 0;
  std::uint64_t dropped_by_now_ = 0;
  bool failed_ = false;
  bool keeps_place_ = false;
  std::uint64_t confirmed_ = 0;
  bool ends_ = false;
  std::optional<SocketAddress> destination_;
  std::optional<std::string> mended_;
  Nanoseconds held_back_{};
  std::uint64_t buffer_bytes_ = 0;
};

}  // namespace rocinante::test
