#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/net/address_filter.h"

namespace rocinante {

/// What a request says about who asks.
struct AccessRequest {
  std::string host;    ///< the header Host
  std::string origin;  ///< the header Origin; empty: not sent
  std::string token;   ///< of the query or of Authorization
  /// Host or Origin was sent and is longer than any of ours.
  bool is_too_long = false;
};

/// A refused request: the status of HTTP, and a sentence for whoever asked.
struct AccessRefusal {
  unsigned status = 0;
  std::string sentence;
};

/// Who may look. Any web page in a browser can open a socket to 127.0.0.1, and a name of its own
/// can be made to lead there: so Host must be this server's, and Origin too where there is one. A
/// plain value.
class AccessRules {
 public:
  /// Own names are addresses, `localhost` and `names`, all with `port`; `origins` are further ones,
  /// "https://robot.example:8443", whose host counts as a name too. bad_argument for an origin that
  /// is none.
  static Result<AccessRules> of(std::uint16_t port, const std::vector<std::string>& names,
                                const std::vector<std::string>& origins, std::string token,
                                AddressFilter allow);

  bool allows(const SocketAddress& client) const { return allow_.allows(client); }
  std::optional<AccessRefusal> refusal(const AccessRequest& request) const;

 private:
  bool isOwnHost(std::string_view host) const;
  bool isOwnOrigin(const AccessRequest& request) const;
  bool hasToken(std::string_view token) const;

  std::uint16_t port_ = 0;
  std::vector<std::string> names_;
  std::vector<std::string> origins_;       ///< as browsers write them
  std::vector<std::string> origin_hosts_;  ///< HOST or HOST:PORT of these
  std::string token_;                      ///< empty: none is asked for
  AddressFilter allow_;
};

/// In a time that depends on the length of `given` alone.
bool sameSecret(std::string_view wanted, std::string_view given);

}  // namespace rocinante
