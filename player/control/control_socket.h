#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/net/address_filter.h"
#include "player/control/control_address.h"
#include "player/control/control_input.h"

namespace rocinante {

/// Hears commands at a UDP port or a Unix socket, and says where ("udp://127.0.0.1:5000"). Over UDP
/// a datagram holds up to 16 lines and is answered by one; strangers (neither this machine nor in
/// `allowed`) are refused, at most one a second told so. A Unix socket is the user's alone (mode
/// 0600), takes 8 connections and is removed at the end; one that a dead player left is replaced.
struct ControlSocket {
  std::unique_ptr<ControlInput> input;
  std::string where;

  /// `told` is given a sentence when a stranger is refused for the first time, on the thread that
  /// serves the socket.
  static Result<ControlSocket> open(const ControlAddress& address, AddressFilter allowed,
                                    std::function<void(std::string)> told = {});
};

}  // namespace rocinante
