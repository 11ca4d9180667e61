#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/net/address_filter.h"
#include "core/net/endpoint.h"
#include "player/control/control_thread.h"

namespace rocinante {

/// Where a player listens for commands: udp://HOST:PORT (also HOST:PORT), or unix:PATH.
struct ControlAddress {
  std::filesystem::path path;  ///< of a Unix socket; empty: use `endpoint`
  Endpoint endpoint;

  static Result<ControlAddress> parse(std::string_view text);
};

/// Listens for commands on a UDP port or a Unix socket; `where` is its address
/// ("udp://127.0.0.1:5000"). Over UDP a datagram holds up to 16 lines and gets one answer; other
/// hosts (not this machine and not in `allowed`) are refused, with at most one answer a second. A
/// Unix socket belongs to the user (mode 0600), accepts 8 connections and is removed at the end;
/// one left by a dead player is replaced.
struct ControlSocket {
  std::unique_ptr<ControlInput> input;
  std::string where;

  /// `notify` is called once, with a sentence, when the first host is refused; on the thread that
  /// serves the socket.
  static Result<ControlSocket> open(const ControlAddress& address, AddressFilter allowed,
                                    std::function<void(std::string)> notify = {});
};

/// ControlSocket::open() of a UDP port.
Result<ControlSocket> openUdpControl(const Endpoint& endpoint, AddressFilter allowed,
                                     std::function<void(std::string)> notify);

/// ControlSocket::open() of a Unix socket.
Result<ControlSocket> openUnixControl(const std::filesystem::path& path);

}  // namespace rocinante
