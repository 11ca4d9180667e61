#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "core/net/datagram_source.h"

namespace rocinante {

/// For a source that passes on only some of another's datagrams: how many of the other's are
/// confirmed when a number of its own are. One thread.
class PassedCount {
 public:
  /// `is_needed` false: nobody will ask, and nothing is remembered.
  explicit PassedCount(bool is_needed) : is_needed_(is_needed) {}

  /// The other's next datagram was passed on, or removed.
  void note(bool passed) {
    if (passed) {
      ++passed_;
    } else if (is_needed_) {
      ++removed_;
      if (removals_.empty() || removals_.back().behind != passed_)
        removals_.push_back({passed_, 0});
      removals_.back().removed = removed_;
    }
  }
  /// Upstream datagrams before ours number count + 1. `count` never decreases.
  std::uint64_t receivedFor(std::uint64_t count) {
    for (; !removals_.empty() && removals_.front().behind <= count; removals_.pop_front()) {
      confirmed_removed_ = removals_.front().removed;
    }
    return count + confirmed_removed_;
  }

 private:
  struct Removal {
    std::uint64_t behind;   ///< passed on before
    std::uint64_t removed;  ///< in total, with these
  };

  bool is_needed_;
  std::uint64_t passed_ = 0;
  std::uint64_t removed_ = 0;
  std::uint64_t confirmed_removed_ = 0;
  std::deque<Removal> removals_;  ///< not confirmed yet
};

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
  virtual bool accepts(const ReceivedDatagram& datagram) = 0;

 private:
  bool takes(const ReceivedDatagram& datagram);

  std::unique_ptr<DatagramSource> inner_;
  PassedCount count_;
  std::vector<ReceivedDatagram> taken_;
};

}  // namespace rocinante
