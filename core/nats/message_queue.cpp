#include "core/nats/message_queue.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>

namespace rocinante {
namespace {

// The library's own share of a message.
constexpr std::size_t kMessageCost = 512;

std::size_t costOf(const natsMsg* message) {
  return static_cast<std::size_t>(natsMsg_GetDataLength(message)) + kMessageCost;
}

}  // namespace

MessageQueue::MessageQueue(std::size_t max_bytes)
    : max_bytes_(max_bytes), event_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

MessageQueue::~MessageQueue() {
  if (event_ >= 0) ::close(event_);
}

void MessageQueue::take(natsConnection*, natsSubscription*, natsMsg* message, void* self) {
  auto& queue = *static_cast<MessageQueue*>(self);
  NatsMessage owned(message);
  const std::lock_guard lock(queue.mutex_);
  // One alone may be larger than all that may wait.
  if (!queue.waiting_.empty() && queue.bytes_ + costOf(message) > queue.max_bytes_) {
    ++queue.dropped_;
    return;
  }
  queue.bytes_ += costOf(message);
  // Stamped under the lock: what swap() leaves behind is younger than its call.
  const auto now = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
  queue.waiting_.push_back({std::move(owned), now});
  if (queue.waiting_.size() == 1 && queue.event_ >= 0) (void)::eventfd_write(queue.event_, 1);
}

void MessageQueue::swap(std::vector<ArrivedMessage>& messages) {
  messages.clear();
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return;
  std::swap(messages, waiting_);
  bytes_ = 0;
  eventfd_t ignored = 0;
  if (event_ >= 0) (void)::eventfd_read(event_, &ignored);
}

std::uint64_t MessageQueue::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

ReceivedDatagram datagramOf(const natsMsg* message, WallTime time) {
  ReceivedDatagram datagram;
  datagram.payload = ByteView(reinterpret_cast<const std::byte*>(natsMsg_GetData(message)),
                              static_cast<std::size_t>(natsMsg_GetDataLength(message)));
  datagram.kernel_time = time;
  datagram.subject = natsMsg_GetSubject(message);
  return datagram;
}

}  // namespace rocinante
