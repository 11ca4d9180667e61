#include "core/nats/nats_client.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <vector>

namespace rocinante {
namespace {

constexpr std::int64_t kConnectMs = 5'000;
constexpr std::int64_t kSettleMs = 5'000;
constexpr std::int64_t kLastWordsMs = 2'000;
constexpr std::int64_t kReconnectWaitMs = 250;
// A server that does not answer is given up after three of these.
constexpr std::int64_t kPingMs = 10'000;
// A client that signs is refused for a signature whose first byte is zero: the library (3.4.1)
// sends none then. The server gives another text to sign each time.
constexpr int kSignatures = 4;
constexpr int kWaitingBytes = 4 << 20;
// Between the library's two threads: the second is seldom behind.
constexpr int kLibraryMessages = 262'144;
constexpr int kLibraryBytes = 64 << 20;
constexpr auto kCallbacks = std::chrono::seconds(20);

std::string lastWords(natsStatus status) {
  natsStatus last = NATS_OK;
  const char* words = nats_GetLastError(&last);
  std::string text = natsStatus_GetText(status);
  // The last words may be those of another call.
  if (last == status && words != nullptr && *words != '\0') text = words;
  // They begin with a place in the library: "(conn.c:733): ".
  if (const std::size_t place = text.find("): "); text.starts_with('(') && place != text.npos) {
    text.erase(0, place + 3);
  }
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// Why the server's certificate was not accepted: OpenSSL's words between its number and its place,
/// "SSL handshake error: 20:unable to get local issuer certificate:depth=0:cert=...". Empty when
/// `words` are no such.
std::string certificateFault(std::string_view words) {
  constexpr std::string_view kBegin = "SSL handshake error: ";
  if (!words.starts_with(kBegin)) return {};
  words.remove_prefix(kBegin.size());
  const std::size_t colon = words.find(':');
  const std::size_t end = words.find(":depth=");
  if (end == words.npos || colon >= end) return {};
  std::string fault(words.substr(colon + 1, end - colon - 1));
  // X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT to X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE.
  const std::string_view number = words.substr(0, colon);
  if (number == "18" || number == "19" || number == "20" || number == "21") {
    fault += "; ca= must name the file of its authority";
  }
  return fault;
}

/// Why the first connection failed.
Error connectError(natsStatus status, const Endpoint& endpoint) {
  const std::string server = endpoint.nats.server();
  switch (status) {
    case NATS_SSL_ERROR: {
      const std::string fault = certificateFault(lastWords(status));
      if (fault.empty()) break;
      return {
          ErrorKind::refused,
          fmt::format("the certificate of the NATS server {} is not accepted: {}", server, fault),
          endpoint.text()};
    }
    case NATS_PROTOCOL_ERROR:
    case NATS_NO_SERVER:
    case NATS_TIMEOUT:
    case NATS_IO_ERROR:
    case NATS_CONNECTION_CLOSED:
      // With TLS 1.3 a server looks at the client's certificate after the handshake, and then
      // closes the connection without a word.
      if (endpoint.nats.tls) {
        return {ErrorKind::refused,
                fmt::format("no NATS server answers over TLS at {}, or it wants another client "
                            "certificate: cert= and key= name its files",
                            server),
                endpoint.text()};
      }
      if (status == NATS_PROTOCOL_ERROR) break;
      return {ErrorKind::refused, "no NATS server answers at " + server, endpoint.text()};
    case NATS_CONNECTION_AUTH_FAILED:
    case NATS_NOT_PERMITTED:
      return {ErrorKind::refused,
              fmt::format("the NATS server {} refuses {}", server,
                          endpoint.nats.user.empty() && endpoint.nats.credentials.empty()
                              ? "a client without user, token or credentials"
                              : "this user, token or these credentials"),
              endpoint.text()};
    case NATS_SECURE_CONNECTION_REQUIRED:
      return {ErrorKind::refused, fmt::format("the NATS server {} wants TLS: add tls=on", server),
              endpoint.text()};
    case NATS_SECURE_CONNECTION_WANTED:
      return {ErrorKind::refused, fmt::format("the NATS server {} has no TLS", server),
              endpoint.text()};
    default:
      break;
  }
  return natsError("connect to the NATS server " + server, status, endpoint);
}

/// Whether a later attempt may succeed by itself: nobody has answered.
bool isAbsent(natsStatus status, const Endpoint& endpoint) {
  // With TLS an answer may look like none.
  if (endpoint.nats.tls) return status == NATS_NO_SERVER;
  return status == NATS_NO_SERVER || status == NATS_TIMEOUT || status == NATS_IO_ERROR ||
         status == NATS_CONNECTION_CLOSED;
}

}  // namespace

Error natsError(std::string_view what, natsStatus status, const Endpoint& endpoint) {
  return {ErrorKind::refused, fmt::format("cannot {}: {}", what, lastWords(status)),
          endpoint.text()};
}

Status NatsClient::configure(natsOptions* options) {
  const NatsEndpoint& nats = endpoint_.nats;
  const auto c = [](const std::string& text) { return text.c_str(); };
  struct Step {
    const char* what;
    natsStatus status;
  };
  const std::string url = "nats://" + nats.server();
  std::vector<Step> steps = {
      {"use the server's address", natsOptions_SetURL(options, c(url))},
      {"set options",
       static_cast<natsStatus>(natsOptions_SetName(options, "rocinante") |
                               natsOptions_SetTimeout(options, kConnectMs) |
                               natsOptions_SetMaxReconnect(options, -1) |
                               natsOptions_SetReconnectWait(options, kReconnectWaitMs) |
                               natsOptions_SetReconnectBufSize(options, kWaitingBytes) |
                               natsOptions_SetPingInterval(options, kPingMs) |
                               natsOptions_SetDisconnectedCB(options, onLost, this) |
                               natsOptions_SetReconnectedCB(options, onReturned, this) |
                               natsOptions_SetClosedCB(options, onClosed, this) |
                               natsOptions_SetErrorHandler(options, onError, this))}};
  if (nats.tls) steps.push_back({"use TLS", natsOptions_SetSecure(options, true)});
  if (!nats.authorities.empty()) {
    steps.push_back({"use the file of ca=",
                     natsOptions_LoadCATrustedCertificates(options, c(nats.authorities))});
  }
  if (!nats.certificate.empty()) {
    steps.push_back({"use the files of cert= and key=",
                     natsOptions_LoadCertificatesChain(options, c(nats.certificate), c(nats.key))});
  }
  if (!nats.credentials.empty()) {
    steps.push_back({"use the file of creds=", natsOptions_SetUserCredentialsFromFiles(
                                                   options, c(nats.credentials), nullptr)});
  } else if (!nats.seed.empty()) {
    steps.push_back({"use the file of nkey=",
                     natsOptions_SetNKeyFromSeed(options, c(nats.user), c(nats.seed))});
  } else if (!nats.password.empty()) {
    steps.push_back({"use the user and password",
                     natsOptions_SetUserInfo(options, c(nats.user), c(nats.password))});
  } else if (!nats.user.empty()) {
    steps.push_back({"use the token", natsOptions_SetToken(options, c(nats.user))});
  }
  for (const Step& step : steps) {
    if (step.status != NATS_OK) return natsError(step.what, step.status, endpoint_);
  }
  return {};
}

Result<std::unique_ptr<NatsClient>> NatsClient::connect(const Endpoint& endpoint) {
  std::unique_ptr<NatsClient> client(new NatsClient(endpoint));
  natsOptions* made = nullptr;
  if (const natsStatus status = natsOptions_Create(&made); status != NATS_OK) {
    return natsError("set options", status, endpoint);
  }
  const std::unique_ptr<natsOptions, NatsDestroy<natsOptions_Destroy>> options(made);
  if (Status configured = client->configure(made); !configured) return configured.error();
  const bool signs = !endpoint.nats.credentials.empty() || !endpoint.nats.seed.empty();
  natsStatus status = natsConnection_Connect(&client->connection_, made);
  for (int tried = 1; signs && status == NATS_CONNECTION_AUTH_FAILED && tried < kSignatures;
       ++tried) {
    status = natsConnection_Connect(&client->connection_, made);
  }
  if (status == NATS_OK) {
    client->has_connected_ = true;
    return client;
  }
  const Error absent = connectError(status, endpoint);
  if (!endpoint.nats.waits || !isAbsent(status, endpoint)) return absent;
  {
    const std::lock_guard lock(client->mutex_);
    client->closed_ = false;
  }
  status = natsOptions_SetRetryOnFailedConnect(made, true, onFirst, client.get());
  if (status == NATS_OK) status = natsConnection_Connect(&client->connection_, made);
  if (status != NATS_OK && status != NATS_NOT_YET_CONNECTED) return connectError(status, endpoint);
  const std::lock_guard lock(client->mutex_);
  client->has_connected_ = client->has_connected_ || status == NATS_OK;
  if (!client->has_connected_) client->news_ = absent.what + " yet; waiting for it";
  return client;
}

std::string NatsClient::serverId() const {
  std::array<char, 256> id{};
  const natsStatus status =
      natsConnection_GetConnectedServerId(connection_, id.data(), id.size() - 1);
  return status == NATS_OK ? std::string(id.data()) : std::string();
}

bool NatsClient::hasConnected() const {
  const std::lock_guard lock(mutex_);
  return has_connected_;
}

void NatsClient::onFirst(natsConnection*, void* self) {
  auto& client = *static_cast<NatsClient*>(self);
  const std::lock_guard lock(client.mutex_);
  client.has_connected_ = true;
  client.news_ = "connected to " + client.endpoint_.text();
}

NatsClient::~NatsClient() {
  if (connection_ == nullptr) return;
  if (isConnected()) (void)natsConnection_FlushTimeout(connection_, kLastWordsMs);
  natsConnection_Close(connection_);
  {
    // The library calls onClosed() last.
    std::unique_lock lock(mutex_);
    closing_.wait_for(lock, kCallbacks, [&] { return closed_; });
  }
  natsConnection_Destroy(connection_);
}

Status NatsClient::settle() {
  const natsStatus status = natsConnection_FlushTimeout(connection_, kSettleMs);
  if (status != NATS_OK) {
    return Error{ErrorKind::refused,
                 fmt::format("the NATS server {} did not confirm what was sent last: {}",
                             endpoint_.nats.server(), natsStatus_GetText(status)),
                 endpoint_.text()};
  }
  const char* words = nullptr;
  if (natsConnection_GetLastError(connection_, &words) != NATS_NOT_PERMITTED) return {};
  return Error{ErrorKind::refused,
               fmt::format("the NATS server {} refuses: {}", endpoint_.nats.server(),
                           words != nullptr ? words : "no reason given"),
               endpoint_.text()};
}

Error NatsClient::turnedAway() const {
  return {ErrorKind::refused,
          fmt::format("the NATS server {} has turned this client away", endpoint_.nats.server()),
          endpoint_.text()};
}

std::optional<std::string> NatsClient::news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, std::nullopt);
}

std::optional<Error> NatsClient::denied() {
  const std::lock_guard lock(mutex_);
  return std::exchange(denied_, std::nullopt);
}

void NatsClient::onLost(natsConnection*, void* self) {
  auto& client = *static_cast<NatsClient*>(self);
  const std::lock_guard lock(client.mutex_);
  client.news_ = fmt::format("the connection of {} is lost; nothing passes until it returns",
                             client.endpoint_.text());
}

void NatsClient::onReturned(natsConnection*, void* self) {
  auto& client = *static_cast<NatsClient*>(self);
  const std::lock_guard lock(client.mutex_);
  client.news_ = fmt::format("connected to {} again; what was sent meanwhile is lost",
                             client.endpoint_.text());
}

void NatsClient::onClosed(natsConnection*, void* self) {
  auto& client = *static_cast<NatsClient*>(self);
  const std::lock_guard lock(client.mutex_);
  client.closed_ = true;
  client.closing_.notify_all();
}

void NatsClient::onError(natsConnection* connection, natsSubscription*, natsStatus status,
                         void* self) {
  auto& client = *static_cast<NatsClient*>(self);
  // Counted: messages for which there was no room.
  if (status == NATS_SLOW_CONSUMER) return;
  const char* words = nullptr;
  (void)natsConnection_GetLastError(connection, &words);
  const std::string text = words != nullptr && *words != '\0' ? words : natsStatus_GetText(status);
  const std::lock_guard lock(client.mutex_);
  if (status == NATS_NOT_PERMITTED) {
    client.denied_ =
        Error{ErrorKind::refused,
              fmt::format("the NATS server {} refuses: {}", client.endpoint_.nats.server(), text),
              client.endpoint_.text()};
  }
  client.news_ = fmt::format("the NATS server {} says: {}", client.endpoint_.nats.server(), text);
}

natsStatus CallbackEnd::watch(natsSubscription* subscription) {
  watching_ = true;
  const auto ended = [](void* self) {
    auto& end = *static_cast<CallbackEnd*>(self);
    const std::lock_guard lock(end.mutex_);
    end.ended_ = true;
    end.over_.notify_all();
  };
  const natsStatus status = natsSubscription_SetOnCompleteCB(subscription, ended, this);
  if (status != NATS_OK) return status;
  return natsSubscription_SetPendingLimits(subscription, kLibraryMessages, kLibraryBytes);
}

void CallbackEnd::wait() {
  if (!watching_) return;
  std::unique_lock lock(mutex_);
  over_.wait_for(lock, kCallbacks, [&] { return ended_; });
}

}  // namespace rocinante
