#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viewer/serve/access_rules.h"

struct lws;

namespace rocinante {

/// What a request's head says; while libwebsockets holds it.
class HttpHead {
 public:
  explicit HttpHead(lws* wsi) : wsi_(wsi) {}

  bool isGet() const;
  bool isHead() const;
  std::string range() const;
  /// Whether a socket may speak this subprotocol.
  bool offers(std::string_view protocol) const;
  AccessRequest accessRequest() const;

 private:
  lws* wsi_;
};

/// Names are lower case and end with a colon.
using HttpHeaders = std::vector<std::pair<std::string, std::string>>;

/// Writes the head of an answer, with what keeps a page and its token to itself. False when the
/// connection is gone.
bool writeHttpHead(lws* wsi, unsigned status, const std::string& type, std::uint64_t size,
                   const HttpHeaders& headers);

}  // namespace rocinante
