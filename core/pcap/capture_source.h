#pragma once

#include <memory>

#include "core/net/datagram_source.h"

namespace rocinante {

/// The UDP datagrams of a capture file: openPcap() for an endpoint with a file.
Result<std::unique_ptr<DatagramSource>> openCaptureSource(const Endpoint& endpoint);

}  // namespace rocinante
