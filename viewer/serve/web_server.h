#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/serve/access_rules.h"
#include "viewer/serve/live_session.h"

namespace rocinante {

/// What a server gives away.
struct WebContent {
  std::string page;  ///< HTML
  int log = -1;      ///< an open file, borrowed; -1: there is none
  std::uint64_t log_bytes = 0;
};

/// HTTP and WebSocket by libwebsockets, in the thread that calls run() (docs/programs/serve.md):
/// `/` is the page, `/log` the log, by ranges too, and sockets have a live session: for pages, and
/// for clients of Foxglove. Memory is bounded: by the number of clients, and for each by
/// `client_bytes`.
class WebServer {
 public:
  /// The subprotocol of the page's socket.
  static constexpr const char* kLiveProtocol = "rocinante.v1";
  /// Foxglove's, by its old name and its new one.
  static constexpr const char* kFoxgloveProtocol = "foxglove.websocket.v1";
  static constexpr const char* kFoxgloveSdkProtocol = "foxglove.sdk.v1";

  struct Options {
    SocketAddress listen;
    std::vector<std::string> origins;              ///< further ones (AccessRules)
    std::string token;                             ///< empty: none is asked for
    AddressFilter allow;                           ///< of clients
    std::filesystem::path certificate, key;        ///< PEM; empty: without TLS
    std::size_t clients = 64;                      ///< sockets, at most
    std::uint64_t client_bytes = 4'000'000;        ///< that wait for one client
    std::function<void(std::string_view)> notify;  ///< lines for whoever runs the server
  };
  struct Counts {
    std::uint64_t clients = 0;  ///< that have opened a socket
    std::uint64_t refused = 0;  ///< requests and connections
    std::uint64_t skipped = 0;  ///< messages that slow clients did not get
  };

  /// Listens. refused when it cannot, or cannot use the certificate.
  static Result<std::unique_ptr<WebServer>> open(Options options, WebContent content);
  virtual ~WebServer() = default;

  virtual std::uint16_t port() const = 0;
  /// From another thread: live data has arrived.
  virtual void wake() = 0;
  /// Serves until `stop` says so, which is asked ten times a second. `live` may be null.
  virtual Status run(LiveSession* live, const std::function<bool()>& stop) = 0;
  virtual Counts counts() const = 0;
};

}  // namespace rocinante
