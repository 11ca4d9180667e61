#include "player/control/control_socket.h"

#include <sys/un.h>

#include <string>
#include <utility>

namespace rocinante {

Result<ControlAddress> ControlAddress::parse(std::string_view text) {
  constexpr std::string_view kUnix = "unix:";
  ControlAddress parsed;
  if (text.starts_with(kUnix)) {
    parsed.path = std::string(text.substr(kUnix.size()));
    if (parsed.path.empty() || parsed.path.native().size() >= sizeof(sockaddr_un::sun_path)) {
      return Error{ErrorKind::bad_argument,
                   "a control endpoint is udp://HOST:PORT or unix:PATH, the path of 1 to 107 bytes",
                   std::string(text)};
    }
    return parsed;
  }
  const Result<Endpoint> endpoint = Endpoint::parse(text);
  if (!endpoint) return endpoint.error();
  if (endpoint->isMulticast()) {
    return Error{ErrorKind::bad_argument, "a control endpoint cannot be a multicast group",
                 std::string(text)};
  }
  parsed.endpoint = *endpoint;
  return parsed;
}

Result<ControlSocket> ControlSocket::open(const ControlAddress& address, AddressFilter allowed,
                                          std::function<void(std::string)> notify) {
  if (!address.path.empty()) return openUnixControl(address.path);
  return openUdpControl(address.endpoint, std::move(allowed), std::move(notify));
}

}  // namespace rocinante
