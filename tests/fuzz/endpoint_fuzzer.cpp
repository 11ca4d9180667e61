// What a person, a script or a file gives as an endpoint: whatever it is, it is refused with a
// short sentence or reads back as the same endpoint, and nothing before an @ is ever shown. Only
// schemes whose hosts are not looked up.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "core/net/endpoint.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view rest(reinterpret_cast<const char*>(data), size);
  for (const std::string_view scheme : {"nats://", "jetstream://", "pcap://"}) {
    const std::string text = std::string(scheme) + std::string(rest);
    const auto endpoint = Endpoint::parse(text);
    if (!endpoint) {
      require(!endpoint.error().what.empty() && endpoint.error().where.size() <= 100);
      require(scheme == "pcap://" || endpoint.error().where.find('@') == std::string::npos);
      continue;
    }
    Endpoint shown = *endpoint;
    shown.nats.password.clear();
    if (shown.nats.seed.empty()) shown.nats.user.clear();
    // An nkey's public key is not shown either, and its seed alone cannot be used.
    if (!shown.nats.seed.empty()) continue;
    const auto again = Endpoint::parse(shown.text());
    require(again.ok() && *again == shown && again->text() == endpoint->text());
  }
  return 0;
}
