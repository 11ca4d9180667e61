#pragma once

#include <memory>

#include "core/net/datagram_source.h"

namespace rocinante {

/// The UDP datagrams of a capture file: openPcap() for an endpoint with a file.
Result<std::unique_ptr<DatagramSource>> openCaptureSource(const Endpoint& endpoint);

struct PcapOptions {
  int buffer_bytes = 32 << 20;  ///< the kernel's buffer for captured frames
};

/// Watches the UDP traffic of an interface, also traffic whose receiver is on this machine, or
/// reads a capture file (pcap or pcapng): with the kernel's or the file's timestamps in
/// nanoseconds, IPv4 and IPv6, VLAN tags, fragments reassembled. Binds nothing and sends nothing.
/// `endpoint` has the scheme pcap. Fails with refused when the system does not let this program
/// capture, with the remedy; bad_argument for a filter that does not compile; unsupported for an
/// unknown link type, or when this build has no libpcap.
Result<std::unique_ptr<DatagramSource>> openPcap(const Endpoint& endpoint,
                                                 const PcapOptions& options);

}  // namespace rocinante
