#pragma once

#include <string>
#include <string_view>

#include "core/pcap/frame_reader.h"

namespace rocinante {

/// How a user's filter is given to the kernel. A filter with ports takes at most the first fragment
/// of a datagram, so the kernel lets all fragments of UDP through, and the filter is asked again
/// about what they make; one that names VLANs moves where everything after it is looked for, so
/// nothing can be added to it and it is asked here, frame by frame. Pure.
struct FilterPlan {
  std::string kernel;  ///< in libpcap's language; empty: everything comes
  FrameReader::Filtered filtered = FrameReader::Filtered::before;
};

FilterPlan planFilter(std::string_view user_filter, LinkType link);

}  // namespace rocinante
