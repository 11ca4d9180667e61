#include "core/pcap/open_source.h"

#include "core/net/filtered_source.h"
#include "core/pcap/pcap_source.h"

namespace rocinante {
namespace {

Result<std::unique_ptr<DatagramSource>> openUnfiltered(const Endpoint& endpoint,
                                                       const InputOptions& options) {
  if (endpoint.isPcap()) {
    PcapOptions watching;
    watching.buffer_bytes = options.receiving.receive_buffer_bytes;
    return openPcap(endpoint, watching);
  }
  Result<UdpReceiver> receiver = UdpReceiver::open(endpoint, options.receiving);
  if (!receiver) return receiver.error();
  return std::make_unique<UdpReceiver>(std::move(*receiver));
}

}  // namespace

Result<std::unique_ptr<DatagramSource>> openSource(const Endpoint& endpoint,
                                                   const InputOptions& options) {
  auto source = openUnfiltered(endpoint, options);
  if (!source || (options.allow.empty() && options.own.empty())) return source;
  return std::make_unique<FilteredSource>(std::move(*source), options.allow, options.own);
}

Result<Sources> openSources(const std::vector<Endpoint>& endpoints, const InputOptions& options) {
  Sources sources;
  for (const Endpoint& each : endpoints) {
    if (!each.file.empty() && endpoints.size() > 1) {
      return Error{
          ErrorKind::bad_argument,
          "a capture file must be the only endpoint: its times are not those of live traffic",
          each.text()};
    }
    auto source = openSource(each, options);
    if (!source) return source.error();
    sources.push_back(std::move(*source));
  }
  return sources;
}

}  // namespace rocinante
