#pragma once

#include <string>
#include <string_view>

#include "core/pcap/frame_reader.h"

namespace rocinante {

/// How a user's filter reaches the kernel. A filter with ports matches at most the first fragment
/// of a datagram, so the kernel passes all UDP fragments, and the filter is applied again to the
/// reassembled datagram. A filter that names VLANs shifts the offsets of everything after it, so
/// nothing can be added to it, and it is applied here, frame by frame. Pure.
struct FilterPlan {
  std::string kernel;  ///< in libpcap's language; empty: no filter
  FrameReader::Filtered filtered = FrameReader::Filtered::before;
};

FilterPlan planFilter(std::string_view user_filter, LinkType link);

}  // namespace rocinante
