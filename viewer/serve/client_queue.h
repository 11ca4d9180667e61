#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "core/base/bytes.h"

namespace rocinante {

/// A message to any number of clients. In front of its bytes is room for the head of a frame, which
/// the library writes there.
class SharedMessage {
 public:
  static constexpr std::size_t kRoom = 32;

  /// Empty bytes to append to.
  static Bytes begin() {
    Bytes bytes;
    bytes.reserve(512);
    bytes.resize(kRoom);
    return bytes;
  }

  SharedMessage() = default;
  explicit SharedMessage(Bytes with_room) : bytes_(std::make_shared<Bytes>(std::move(with_room))) {}

  explicit operator bool() const { return bytes_ != nullptr; }
  std::size_t size() const { return bytes_->size() - kRoom; }
  std::byte* data() const { return bytes_->data() + kRoom; }

 private:
  std::shared_ptr<Bytes> bytes_;
};

/// What a client has yet to be sent, within a limit of bytes. One that is too slow for it loses
/// what waits, and is greeted anew with the present state once it has taken what it was being sent:
/// so it skips moments, and is never waited for. One thread.
class ClientQueue {
 public:
  explicit ClientQueue(std::uint64_t most_bytes) : most_bytes_(most_bytes) {}

  /// A greeting, which is taken whatever its size: it is as large as the state, which is bounded.
  void greet(const std::vector<SharedMessage>& greeting) {
    needs_greeting_ = false;
    for (const SharedMessage& each : greeting) push(each);
    greeting_bytes_ = bytes_;
  }
  /// Does nothing while a greeting is due.
  void add(const SharedMessage& message) {
    if (needs_greeting_) return;
    if (bytes_ + message.size() > most_bytes_ + greeting_bytes_) {
      skipped_ += waiting_.size() + 1;
      waiting_.clear();
      bytes_ = greeting_bytes_ = 0;
      needs_greeting_ = true;
      return;
    }
    push(message);
  }

  /// Everything was taken, and the client has missed something.
  bool needsGreeting() const { return needs_greeting_; }
  bool empty() const { return waiting_.empty(); }
  SharedMessage take() {
    SharedMessage front = std::move(waiting_.front());
    waiting_.pop_front();
    bytes_ -= front.size();
    greeting_bytes_ -= std::min<std::uint64_t>(greeting_bytes_, front.size());
    return front;
  }

  std::uint64_t bytes() const { return bytes_; }
  /// Messages that the client never got.
  std::uint64_t skipped() const { return skipped_; }

 private:
  void push(const SharedMessage& message) {
    waiting_.push_back(message);
    bytes_ += message.size();
  }

  std::uint64_t most_bytes_;
  std::deque<SharedMessage> waiting_;
  std::uint64_t bytes_ = 0, greeting_bytes_ = 0, skipped_ = 0;
  bool needs_greeting_ = true;
};

}  // namespace rocinante
