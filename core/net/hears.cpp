#include "core/net/hears.h"

#include "core/net/interfaces.h"

namespace rocinante {

bool hears(const DatagramSource& source, const Endpoint& to, const std::string& to_server) {
  const Endpoint& from = source.endpoint();
  if (!from.isNats() || !to.isNats()) return hears(from, source.boundAddress(), to);
  if (from.scheme != Endpoint::Scheme::nats || to.scheme != Endpoint::Scheme::nats) return false;
  const std::string id = source.serverId();
  const bool same_server =
      from.nats.server() == to.nats.server() || (!id.empty() && id == to_server);
  return same_server && subjectMatches(from.nats.listenedSubject(), to.nats.subject + ".x");
}

bool hears(const Endpoint& from, const SocketAddress& bound, const Endpoint& to) {
  if (from.isNats() || to.isNats() || from.isPcap() || to.isPcap()) return false;
  if (bound.port != to.address.port || bound.is_ipv6 != to.address.is_ipv6) return false;
  if (bound.isAny()) return !to.isMulticast() && isOwnAddress(to.address);
  const bool other_interface =
      !to.interface.empty() && !from.interface.empty() && to.interface != from.interface;
  return !other_interface && bound.address == to.address.address;
}

}  // namespace rocinante
