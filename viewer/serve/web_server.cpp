#include "viewer/serve/web_server.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libwebsockets.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>

#include "viewer/serve/byte_range.h"
#include "viewer/serve/http_head.h"
#include "viewer/serve/idle_connections.h"
#include "viewer/serve/library_complaint.h"
#include "viewer/serve/socket_client.h"

namespace rocinante {
namespace {

static_assert(LWS_PRE <= SharedMessage::kRoom);

/// What is sent of a file in one go.
constexpr std::size_t kPieceBytes = 32 * 1024;
constexpr std::array kProtocols{WebServer::kLiveProtocol, WebServer::kFoxgloveProtocol,
                                WebServer::kFoxgloveSdkProtocol};
constexpr Nanoseconds kLongestSleep = std::chrono::milliseconds(100);
/// At most this often a message goes out: one for each packet would cost each of them a frame.
constexpr Nanoseconds kPace = std::chrono::milliseconds(5);
/// A request that does not come to its end.
constexpr unsigned kRequestSeconds = 10;
/// Connections that ask for nothing, beside those of clients.
constexpr std::size_t kMostIdle = 64;
/// Silent sockets are asked, and given up.
constexpr lws_retry_bo_t kIdle = {nullptr, 0, 0, 20, 40, 0};

/// An answer that is being sent.
struct Transfer {
  std::string_view text;  ///< of the page; empty: of the log
  ByteRange left;
};

class LwsServer final : public WebServer {
 public:
  LwsServer(Options options, WebContent content)
      : options_(std::move(options)), content_(std::move(content)) {
    timer_.server = this;
  }
  ~LwsServer() override {
    if (context_ != nullptr) ::lws_context_destroy(context_);
  }

  Status open();
  std::uint16_t port() const override { return port_; }
  void wake() override { ::lws_cancel_service(context_); }
  Status run(LiveSession* live, const std::function<bool()>& stop) override;
  Counts counts() const override { return counts_; }

 private:
  struct Timer {
    lws_sorted_usec_list_t sul{};
    LwsServer* server = nullptr;
  };
  static int onHttp(lws* wsi, lws_callback_reasons reason, void* user, void* in, std::size_t size);
  static int onSocket(lws* wsi, lws_callback_reasons reason, void* user, void* in,
                      std::size_t size);
  static LwsServer* of(lws* wsi) {
    return static_cast<LwsServer*>(::lws_context_user(::lws_get_context(wsi)));
  }

  bool mayConnect(int socket);
  std::optional<AccessRefusal> refusalOf(lws* wsi, bool is_socket) const;
  void idles(lws* wsi);
  int answered(lws* wsi);
  int answerText(lws* wsi, unsigned status, std::string_view text);
  int request(lws* wsi, std::string_view path);
  int sendFile(lws* wsi, std::string_view text, const std::string& type, std::uint64_t size);
  int sendPiece(lws* wsi);
  void admit(lws* wsi);
  int sendNext(lws* wsi);
  int hear(lws* wsi, std::string_view part);
  void step();
  void stepIn(Nanoseconds sleep);
  void stepSoon();

  Options options_;
  WebContent content_;
  AccessRules rules_;
  std::vector<lws_protocols> protocols_;
  lws_context* context_ = nullptr;
  std::uint16_t port_ = 0;
  Timer timer_;
  LiveSession* live_ = nullptr;
  std::chrono::steady_clock::time_point stepped_{};
  std::map<lws*, Transfer> transfers_;
  std::map<lws*, std::unique_ptr<SocketClient>> clients_;
  IdleConnections<lws*> idle_{kMostIdle};
  Counts counts_;
};

Status LwsServer::open() {
  collectComplaints();
  protocols_ = {{"http-only", onHttp, 0, 4096, 0, nullptr, 0}};
  for (const char* name : kProtocols) {
    protocols_.push_back({name, onSocket, 0, 4096, 0, nullptr, 0});
  }
  protocols_.push_back({nullptr, nullptr, 0, 0, 0, nullptr, 0});
  lws_context_creation_info info{};
  info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
  info.user = this;
  info.fd_limit_per_thread = static_cast<unsigned>(2 * options_.clients + 2 * kMostIdle);
  const bool is_secure = !options_.certificate.empty();
  if (is_secure) info.options |= LWS_SERVER_OPTION_DO_SSL_GLOBAL_INIT;
  context_ = ::lws_create_context(&info);
  if (context_ == nullptr) {
    return Error{ErrorKind::refused, "the web server cannot start: " + lastComplaint(), {}};
  }
  const std::string host = options_.listen.hostText();
  const std::string certificate = options_.certificate.string(), key = options_.key.string();
  info.options |= LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND;
  info.options |= options_.listen.is_ipv6
                      ? LWS_SERVER_OPTION_IPV6_V6ONLY_MODIFY | LWS_SERVER_OPTION_IPV6_V6ONLY_VALUE
                      : LWS_SERVER_OPTION_DISABLE_IPV6;
  info.iface = options_.listen.isAny() ? nullptr : host.c_str();
  info.port = options_.listen.port;
  info.protocols = protocols_.data();
  info.vhost_name = "rocinante";
  info.alpn = "http/1.1";
  info.timeout_secs = kRequestSeconds;
  info.keepalive_timeout = kRequestSeconds;
  info.retry_and_idle_policy = &kIdle;
  if (is_secure) {
    info.ssl_cert_filepath = certificate.c_str();
    info.ssl_private_key_filepath = key.c_str();
  }
  lws_vhost* const vhost = ::lws_create_vhost(context_, &info);
  if (vhost == nullptr) {
    // The library opens the certificate before the port, and says of the port less than the system.
    if (is_secure && lastComplaint().find("ssl") != std::string::npos) {
      return Error{ErrorKind::refused, "cannot use this certificate with this key", certificate};
    }
    return Error{ErrorKind::refused,
                 "cannot listen here: the port is taken, or the address is not this machine's",
                 options_.listen.text()};
  }
  port_ = static_cast<std::uint16_t>(::lws_get_vhost_listen_port(vhost));
  std::array<char, 256> name{};
  std::vector<std::string> names;
  if (::gethostname(name.data(), name.size() - 1) == 0) names.emplace_back(name.data());
  auto rules = AccessRules::of(port_, names, options_.origins, options_.token, options_.allow);
  if (!rules) return rules.error();
  rules_ = std::move(*rules);
  return {};
}

Status LwsServer::run(LiveSession* live, const std::function<bool()>& stop) {
  live_ = live;
  step();
  while (!stop()) {
    if (::lws_service(context_, 0) < 0) {
      return Error{ErrorKind::refused, "the web server has stopped: " + lastComplaint(), {}};
    }
  }
  return {};
}

/// Brings every client what is new, and comes again when there may be more.
void LwsServer::step() {
  stepped_ = std::chrono::steady_clock::now();
  Nanoseconds sleep = kLongestSleep;
  if (live_ != nullptr) {
    const std::vector<SharedMessage> messages = live_->step();
    const bool reads_desk =
        std::ranges::any_of(clients_, [](const auto& each) { return each.second->readsDesk(); });
    const bool is_filled = reads_desk && live_->fillDesk();
    for (auto& [wsi, client] : clients_) {
      for (const SharedMessage& message : messages) client->add(message);
      if (!messages.empty() || is_filled) ::lws_callback_on_writable(wsi);
    }
    // The desk may have been filled too lately for what has just come.
    const Nanoseconds longest = reads_desk ? 4 * kPace : kLongestSleep;
    sleep = std::clamp(live_->idle(), kPace, longest);
  }
  stepIn(sleep);
}

void LwsServer::stepIn(Nanoseconds sleep) {
  const auto on_time = [](lws_sorted_usec_list_t* sul) {
    lws_container_of(sul, Timer, sul)->server->step();
  };
  ::lws_sul_schedule(context_, 0, &timer_.sul, on_time, sleep.count() / 1000);
}

void LwsServer::stepSoon() {
  const Nanoseconds since = std::chrono::steady_clock::now() - stepped_;
  if (since >= kPace) {
    step();
  } else {
    stepIn(kPace - since);
  }
}

bool LwsServer::mayConnect(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  std::array<char, NI_MAXHOST> host{};
  if (::getpeername(socket, generic, &size) != 0 ||
      ::getnameinfo(generic, size, host.data(), host.size(), nullptr, 0, NI_NUMERICHOST) != 0) {
    return false;
  }
  const auto peer = SocketAddress::parse(host.data(), 0);
  if (peer && rules_.allows(withoutMapping(*peer))) return true;
  ++counts_.refused;
  if (options_.notify)
    options_.notify(std::string(host.data()) + " is not in --allow: not answered");
  return false;
}

std::optional<AccessRefusal> LwsServer::refusalOf(lws* wsi, bool is_socket) const {
  const HttpHead head(wsi);
  if (auto refusal = rules_.refusal(head.accessRequest())) return refusal;
  if (!is_socket) return {};
  const auto offers = [&](const char* name) { return head.offers(name); };
  if (std::ranges::none_of(kProtocols, offers)) {
    return AccessRefusal{400, fmt::format("A socket here speaks {}.", fmt::join(kProtocols, ", "))};
  }
  if (live_ == nullptr) {
    return AccessRefusal{404, "A recorded log is served here: there is nothing live."};
  }
  if (clients_.size() < options_.clients) return {};
  return AccessRefusal{
      503, fmt::format("{} viewers are connected, the limit of --clients.", options_.clients)};
}

/// The connection asks for nothing now; one that has asked for nothing longer may end for it.
void LwsServer::idles(lws* wsi) {
  std::array<char, NI_MAXHOST> host{};
  ::lws_get_peer_simple(wsi, host.data(), host.size());
  const auto ends = idle_.add(wsi, host.data());
  if (!ends) return;
  ++counts_.refused;
  ::lws_set_timeout(*ends, PENDING_TIMEOUT_AWAITING_CLIENT_HS_SEND, LWS_TO_KILL_ASYNC);
}

/// After the last byte of an answer.
int LwsServer::answered(lws* wsi) {
  idles(wsi);
  return ::lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

int LwsServer::answerText(lws* wsi, unsigned status, std::string_view text) {
  ++counts_.refused;
  const std::string body = std::string(text) + "\n";
  HttpHeaders headers;
  if (status == 405) headers.emplace_back("allow:", "GET, HEAD");
  if (!writeHttpHead(wsi, status, "text/plain; charset=utf-8", body.size(), headers)) return -1;
  if (HttpHead(wsi).isHead()) return answered(wsi);
  Bytes bytes(LWS_PRE);
  const ByteView view = bytesOf(body);
  bytes.insert(bytes.end(), view.begin(), view.end());
  auto* const at = reinterpret_cast<unsigned char*>(bytes.data()) + LWS_PRE;
  if (::lws_write(wsi, at, body.size(), LWS_WRITE_HTTP_FINAL) < 0) return -1;
  return answered(wsi);
}

int LwsServer::request(lws* wsi, std::string_view path) {
  if (const auto refusal = refusalOf(wsi, false)) {
    return answerText(wsi, refusal->status, refusal->sentence);
  }
  const HttpHead head(wsi);
  if (!head.isGet() && !head.isHead()) {
    return answerText(wsi, 405, "Only GET and HEAD are answered here.");
  }
  if (path == "/") {
    return sendFile(wsi, content_.page, "text/html; charset=utf-8", content_.page.size());
  }
  if (path == "/log" && content_.log >= 0) {
    return sendFile(wsi, {}, "application/octet-stream", content_.log_bytes);
  }
  if (path == "/live") return answerText(wsi, 426, "This is a WebSocket of rocinante.v1.");
  return answerText(wsi, 404, "Not found. The page is at /.");
}

int LwsServer::sendFile(lws* wsi, std::string_view text, const std::string& type,
                        std::uint64_t size) {
  HttpHeaders headers;
  ByteRange part{0, size};
  unsigned status = 200;
  if (text.empty()) {
    headers.emplace_back("accept-ranges:", "bytes");
    if (const auto asked = parseByteRange(HttpHead(wsi).range(), size)) {
      if (asked->count == 0) return answerText(wsi, 416, "The log is shorter than that.");
      part = *asked;
      status = 206;
      headers.emplace_back("content-range:", fmt::format("bytes {}-{}/{}", part.first,
                                                         part.first + part.count - 1, size));
    }
  }
  if (!writeHttpHead(wsi, status, type, part.count, headers)) return -1;
  if (HttpHead(wsi).isHead()) return answered(wsi);
  transfers_[wsi] = {text, part};
  ::lws_callback_on_writable(wsi);
  return 0;
}

int LwsServer::sendPiece(lws* wsi) {
  const auto found = transfers_.find(wsi);
  if (found == transfers_.end()) return 0;
  Transfer& transfer = found->second;
  const std::size_t size = std::min<std::uint64_t>(transfer.left.count, kPieceBytes);
  std::array<unsigned char, LWS_PRE + kPieceBytes> piece;
  unsigned char* const at = piece.data() + LWS_PRE;
  if (!transfer.text.empty()) {
    std::copy_n(transfer.text.data() + transfer.left.first, size, at);
  } else if (::pread(content_.log, at, size, static_cast<off_t>(transfer.left.first)) !=
             static_cast<ssize_t>(size)) {
    return -1;  // the file was cut: a promise that cannot be kept
  }
  transfer.left.first += size;
  transfer.left.count -= size;
  const bool is_last = transfer.left.count == 0;
  if (is_last) transfers_.erase(found);
  if (::lws_write(wsi, at, size, is_last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) < 0) return -1;
  if (is_last) return answered(wsi);
  ::lws_callback_on_writable(wsi);
  return 0;
}

int LwsServer::onHttp(lws* wsi, lws_callback_reasons reason, void* user, void* in,
                      std::size_t size) {
  LwsServer* const server = of(wsi);
  switch (reason) {
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      server->stepSoon();
      return 0;
    case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
      return server->mayConnect(static_cast<int>(reinterpret_cast<std::intptr_t>(in))) ? 0 : 1;
    case LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED:
      server->idles(wsi);
      return 0;
    case LWS_CALLBACK_WSI_DESTROY:
      server->idle_.remove(wsi);
      return 0;
    case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
      server->idle_.remove(wsi);
      if (const auto refusal = server->refusalOf(wsi, true)) {
        return server->answerText(wsi, refusal->status, refusal->sentence) < 0 ? -1 : 1;
      }
      return 0;
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
      return 1;  // a socket without a subprotocol
    case LWS_CALLBACK_HTTP:
      server->idle_.remove(wsi);
      return server->request(wsi, {static_cast<const char*>(in), size});
    case LWS_CALLBACK_HTTP_WRITEABLE:
      return server->sendPiece(wsi);
    case LWS_CALLBACK_CLOSED_HTTP:
      server->transfers_.erase(wsi);
      server->idle_.remove(wsi);
      return 0;
    default:
      return ::lws_callback_http_dummy(wsi, reason, user, in, size);
  }
}

void LwsServer::admit(lws* wsi) {
  const bool is_page = std::string_view(::lws_get_protocol(wsi)->name) == kLiveProtocol;
  auto& client = clients_[wsi];
  if (is_page) {
    client = std::make_unique<PageSocket>(*live_, options_.client_bytes);
  } else {
    live_->fillDesk();
    client = std::make_unique<FoxgloveSocket>(live_->desk());
  }
  ++counts_.clients;
  ::lws_callback_on_writable(wsi);
}

int LwsServer::sendNext(lws* wsi) {
  const auto next = clients_.at(wsi)->next();
  if (!next) return 0;
  auto* const at = reinterpret_cast<unsigned char*>(next->message.data());
  const auto kind = next->is_text ? LWS_WRITE_TEXT : LWS_WRITE_BINARY;
  if (::lws_write(wsi, at, next->message.size(), kind) < 0) return -1;
  ::lws_callback_on_writable(wsi);
  return 0;
}

int LwsServer::hear(lws* wsi, std::string_view part) {
  const bool is_first = ::lws_is_first_fragment(wsi) != 0;
  const bool is_last = ::lws_is_final_fragment(wsi) != 0;
  const bool is_binary = ::lws_frame_is_binary(wsi) != 0;
  if (clients_.at(wsi)->receive(part, is_first, is_last, is_binary)) {
    if (is_last) ::lws_callback_on_writable(wsi);
    return 0;
  }
  ::lws_close_reason(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, nullptr, 0);
  return -1;
}

int LwsServer::onSocket(lws* wsi, lws_callback_reasons reason, void*, void* in, std::size_t size) {
  LwsServer* const server = of(wsi);
  switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
      return server->refusalOf(wsi, true) ? 1 : 0;
    case LWS_CALLBACK_ESTABLISHED:
      server->admit(wsi);
      return 0;
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return server->sendNext(wsi);
    case LWS_CALLBACK_RECEIVE:
      return server->hear(wsi, {static_cast<const char*>(in), size});
    case LWS_CALLBACK_CLOSED: {
      const auto client = server->clients_.find(wsi);
      if (client == server->clients_.end()) return 0;
      server->counts_.skipped += client->second->skipped();
      server->clients_.erase(client);
      return 0;
    }
    default:
      return 0;
  }
}

}  // namespace

Result<std::unique_ptr<WebServer>> WebServer::open(Options options, WebContent content) {
  auto server = std::make_unique<LwsServer>(std::move(options), std::move(content));
  if (Status opened = server->open(); !opened) return opened.error();
  return server;
}

}  // namespace rocinante
