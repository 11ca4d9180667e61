#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "core/base/time.h"
#include "core/nats/nats_client.h"
#include "core/net/datagram_source.h"

namespace rocinante {

/// The most that one receive() gives.
constexpr std::size_t kMessageBatch = 512;

/// A message, and when it arrived.
struct ArrivedMessage {
  NatsMessage message;
  WallTime time;
};

/// Carries messages from the library's thread to the one that receives, behind a bound on their
/// bytes. For core/nats's own sources.
class MessageQueue {
 public:
  explicit MessageQueue(std::size_t max_bytes);
  ~MessageQueue();
  MessageQueue(const MessageQueue&) = delete;
  MessageQueue& operator=(const MessageQueue&) = delete;

  /// For the library's thread: a natsMsgHandler, whose closure is the queue.
  static void take(natsConnection*, natsSubscription*, natsMsg* message, void* self);

  /// All that wait; empty when there are none. Clears `messages` first.
  void swap(std::vector<ArrivedMessage>& messages);
  /// Messages for which there was no room.
  std::uint64_t dropped() const;
  /// For poll(): readable while messages wait; -1 when the system has none.
  int fileDescriptor() const { return event_; }

 private:
  const std::size_t max_bytes_;
  int event_;
  mutable std::mutex mutex_;
  std::vector<ArrivedMessage> waiting_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

/// The message as a datagram, borrowed from it; it may be longer than UDP can carry.
ReceivedDatagram datagramOf(const natsMsg* message, WallTime time);

}  // namespace rocinante
