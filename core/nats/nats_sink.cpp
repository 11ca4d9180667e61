#include "core/nats/nats_sink.h"

#include <chrono>
#include <string>
#include <thread>

#include "core/nats/nats_client.h"
#include "core/nats/nats_subject.h"

namespace rocinante {
namespace {

constexpr int kTriesWhileLost = 1'000;

class NatsSink final : public DatagramSink {
 public:
  explicit NatsSink(std::unique_ptr<NatsClient> client)
      : client_(std::move(client)), subject_(client_->endpoint().nats.subject) {}

  Status send(std::span<const ByteView> payloads) override {
    while (!payloads.empty()) {
      const auto sent = sendWithoutWaiting(payloads);
      if (!sent) return sent.error();
      payloads = payloads.subspan(*sent);
    }
    return {};
  }

  Result<std::size_t> sendWithoutWaiting(std::span<const ByteView> payloads) override {
    if (auto denied = client_->denied()) return std::move(*denied);
    std::size_t sent = 0;
    for (const ByteView payload : payloads) {
      const std::string& subject = subject_(payload);
      const natsStatus status = publish(subject, payload);
      if (status != NATS_OK && sent > 0) return sent;
      if (status == NATS_INSUFFICIENT_BUFFER) {
        return Error{ErrorKind::refused,
                     "the NATS server " + endpoint().nats.server() +
                         " is away, and 4 MiB already wait for it",
                     endpoint().text()};
      }
      if (status != NATS_OK) return natsError("publish", status, endpoint());
      ++sent;
      any_sent_ = true;
    }
    return sent;
  }

  Result<bool> isReady() const override {
    if (client_->isClosed()) return client_->turnedAway();
    return client_->hasConnected();
  }
  std::optional<std::string> news() override { return client_->news(); }
  Status flush() override { return any_sent_ ? client_->settle() : Status(); }
  int fileDescriptor() const override { return -1; }
  std::string serverId() const override { return client_->serverId(); }
  const Endpoint& endpoint() const override { return client_->endpoint(); }

 private:
  /// A write may find that the connection is lost before the library's own thread does: from then
  /// on the library keeps what is published. It takes microseconds, once for each lost connection.
  natsStatus publish(const std::string& subject, ByteView payload) {
    const auto once = [&] {
      return natsConnection_Publish(client_->get(), subject.c_str(), payload.data(),
                                    static_cast<int>(payload.size()));
    };
    natsStatus status = once();
    for (int tries = 0; status == NATS_IO_ERROR && tries < kTriesWhileLost; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      status = once();
    }
    return status;
  }

  std::unique_ptr<NatsClient> client_;
  SubjectOf subject_;
  bool any_sent_ = false;
};

}  // namespace

Result<std::unique_ptr<DatagramSink>> openNatsSink(const Endpoint& to) {
  if (to.scheme == Endpoint::Scheme::jetstream) {
    return Error{ErrorKind::bad_argument,
                 "jetstream:// is only read: a stream keeps what is sent to its subjects, as "
                 "nats://HOST/SUBJECT",
                 to.text()};
  }
  if (to.nats.hasWildcard()) {
    return Error{ErrorKind::bad_argument, "a subject to send to has no wildcards", to.text()};
  }
  auto client = NatsClient::connect(to);
  if (!client) return client.error();
  return std::make_unique<NatsSink>(std::move(*client));
}

}  // namespace rocinante
