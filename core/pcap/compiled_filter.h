#pragma once

#include <string>

#include "core/base/result.h"
#include "core/pcap/frame_reader.h"

namespace rocinante {

/// A filter in libpcap's language, for frames of any link type: compiled for `first` now, and for
/// each other link when its first frame comes (where it means nothing, it takes none).
/// bad_argument, without a place, when it does not compile.
Result<FrameReader::Filter> compiledFilter(const std::string& text, LinkType first);

}  // namespace rocinante
