#pragma once

#include <nats/nats.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// For core/nats's own sources.

/// One of the library's objects, freed by its own function.
template <auto destroy>
struct NatsDestroy {
  template <class Object>
  void operator()(Object* object) const {
    destroy(object);
  }
};
using NatsMessage = std::unique_ptr<natsMsg, NatsDestroy<natsMsg_Destroy>>;
using NatsSubscription = std::unique_ptr<natsSubscription, NatsDestroy<natsSubscription_Destroy>>;

/// "cannot DO: Timeout", from a status of the library and its own last words.
Error natsError(std::string_view what, natsStatus status, const Endpoint& endpoint);

/// libnats 3.4 writes fractions of a second without their leading zeros: such times begin early.
inline WallTime writableTime(WallTime time) {
  const auto second = std::chrono::floor<std::chrono::seconds>(time);
  return time - second < std::chrono::milliseconds(100) ? WallTime(second) : time;
}

/// A connection to a server. The library's threads keep it, and connect again when it breaks.
class NatsClient {
 public:
  /// Options, credentials and the first connection; within 5 s. Where no server answers and the
  /// endpoint waits, the client is made all the same: isConnected() later, and news() tells so.
  static Result<std::unique_ptr<NatsClient>> connect(const Endpoint& endpoint);
  /// Sends what is left for at most 2 s, closes, and waits until no callback runs any more.
  ~NatsClient();
  NatsClient(const NatsClient&) = delete;
  NatsClient& operator=(const NatsClient&) = delete;

  natsConnection* get() const { return connection_; }
  const Endpoint& endpoint() const { return endpoint_; }

  /// Waits until the server has what was sent and its answer is here: refused with the server's
  /// reason when it has denied something.
  Status settle();
  /// What changed since the last call, as a sentence for the user.
  std::optional<std::string> news();
  /// What the server has denied since the last call.
  std::optional<Error> denied();
  /// The server turned this client away for good.
  bool isClosed() const { return natsConnection_IsClosed(connection_); }
  Error turnedAway() const;
  /// Of the server that it is connected to; empty while it is not.
  std::string serverId() const;
  /// True from the first connection on.
  bool hasConnected() const;
  bool isConnected() const {
    return natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED;
  }

 private:
  explicit NatsClient(Endpoint endpoint) : endpoint_(std::move(endpoint)) {}
  Status configure(natsOptions* options);
  static void onFirst(natsConnection*, void* self);

  static void onLost(natsConnection*, void* self);
  static void onReturned(natsConnection*, void* self);
  static void onClosed(natsConnection*, void* self);
  static void onError(natsConnection*, natsSubscription*, natsStatus status, void* self);

  Endpoint endpoint_;
  natsConnection* connection_ = nullptr;
  mutable std::mutex mutex_;
  std::condition_variable closing_;
  bool closed_ = false;
  bool has_connected_ = false;
  std::optional<std::string> news_;
  std::optional<Error> denied_;
};

/// The end of a subscription's callbacks, and the bound on what waits for them in the library.
class CallbackEnd {
 public:
  natsStatus watch(natsSubscription* subscription);
  /// Returns when no callback will run any more, after the connection was closed.
  void wait();

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool watching_ = false;
  bool ended_ = false;
};

}  // namespace rocinante
