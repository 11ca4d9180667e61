// Replaces pcap_source.cpp in a build without libpcap.
#include "core/pcap/pcap_source.h"

namespace rocinante {

Result<std::unique_ptr<DatagramSource>> openPcap(const Endpoint& endpoint, const PcapOptions&) {
  return Error{ErrorKind::unsupported,
               "this build does not support pcap:// (`rocinante --version --parts` says why)",
               endpoint.text()};
}

}  // namespace rocinante
