#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/pcap/frame_reader.h"

namespace rocinante {

/// A filter in libpcap's language, for frames of any link type: compiled for `first` now, and for
/// each other link when its first frame comes (where it means nothing, it takes none).
/// bad_argument, without a place, when it does not compile.
Result<FrameReader::Filter> compiledFilter(const std::string& text, LinkType first);

/// How a user's filter reaches the kernel that watches an interface. What the kernel drops nobody
/// counts, so it drops only what FrameReader would not use (docs/decisions/035): TCP and, with a
/// filter, plain UDP that the filter does not choose and other plain IP. What no filter of
/// tcpdump's can see into (fragments, extension headers, VLAN tags) passes, and the filter is
/// applied to the datagram in it. A filter that names VLANs shifts the offsets of everything after
/// it, so nothing can be added to it, and it is applied here, frame by frame. Capture files are not
/// filtered before they are read. Pure.
struct FilterPlan {
  std::string kernel;  ///< in libpcap's language
  FrameReader::Filtered filtered = FrameReader::Filtered::before;
  bool keep_tags = false;
};

FilterPlan planFilter(std::string_view user_filter);

/// Whether the filter is about VLAN tags.
bool namesTags(std::string_view user_filter);

}  // namespace rocinante
