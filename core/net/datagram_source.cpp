#include "core/net/datagram_source.h"

namespace rocinante {

std::string boundText(const DatagramSource& source) {
  Endpoint endpoint = source.endpoint();
  endpoint.address.port = source.boundAddress().port;
  return endpoint.text();
}

}  // namespace rocinante
