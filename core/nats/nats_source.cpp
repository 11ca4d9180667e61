#include "core/nats/nats_source.h"

#include <algorithm>

#include "core/nats/message_queue.h"
#include "core/nats/nats_client.h"

namespace rocinante {
namespace {

class NatsSource final : public DatagramSource {
 public:
  NatsSource(std::unique_ptr<NatsClient> client, const NatsSourceOptions& options)
      : queue_(options.buffer_bytes), client_(std::move(client)) {}
  ~NatsSource() override {
    if (subscription_) (void)natsSubscription_Unsubscribe(subscription_.get());
    subscription_.reset();
    client_.reset();
    end_.wait();
  }

  Status subscribe() {
    const std::string subject = client_->endpoint().nats.listenedSubject();
    natsSubscription* made = nullptr;
    natsStatus status = natsConnection_Subscribe(&made, client_->get(), subject.c_str(),
                                                 MessageQueue::take, &queue_);
    subscription_.reset(made);
    if (status == NATS_OK) status = end_.watch(made);
    if (status != NATS_OK) return natsError("subscribe", status, client_->endpoint());
    return client_->hasConnected() ? client_->settle() : Status();
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    if (next_ == messages_.size()) {
      queue_.swap(messages_);
      next_ = 0;
    }
    if (messages_.empty() && client_->isClosed()) return client_->turnedAway();
    datagrams_.clear();
    const std::size_t end = std::min(messages_.size(), next_ + kMessageBatch);
    for (; next_ < end; ++next_) {
      datagrams_.push_back(datagramOf(messages_[next_].message.get(), messages_[next_].time));
    }
    return std::span<const ReceivedDatagram>(datagrams_);
  }

  std::uint64_t dropped() const override {
    std::int64_t in_library = 0;
    // After the connection is closed it says no more.
    if (natsSubscription_GetDropped(subscription_.get(), &in_library) == NATS_OK) {
      dropped_in_library_ = static_cast<std::uint64_t>(std::max<std::int64_t>(in_library, 0));
    }
    return queue_.dropped() + dropped_in_library_;
  }
  Result<std::uint64_t> droppedByNow() override { return dropped(); }
  std::optional<std::string> maintain() override { return client_->news(); }
  int fileDescriptor() const override { return queue_.fileDescriptor(); }
  std::string serverId() const override { return client_->serverId(); }
  const Endpoint& endpoint() const override { return client_->endpoint(); }
  const SocketAddress& boundAddress() const override { return client_->endpoint().address; }

 private:
  MessageQueue queue_;
  CallbackEnd end_;
  std::unique_ptr<NatsClient> client_;
  NatsSubscription subscription_;
  std::vector<ArrivedMessage> messages_;
  std::size_t next_ = 0;  ///< of messages_, to be given
  std::vector<ReceivedDatagram> datagrams_;
  mutable std::uint64_t dropped_in_library_ = 0;
};

}  // namespace

Result<std::unique_ptr<DatagramSource>> openNatsSource(const Endpoint& endpoint,
                                                       const NatsSourceOptions& options) {
  auto client = NatsClient::connect(endpoint);
  if (!client) return client.error();
  auto source = std::make_unique<NatsSource>(std::move(*client), options);
  if (Status subscribed = source->subscribe(); !subscribed) return subscribed.error();
  return source;
}

}  // namespace rocinante
