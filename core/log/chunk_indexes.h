#pragma once

#include <vector>

#include "core/mcap/parse_record.h"
#include "core/mcap/records.h"

namespace rocinante {

/// True when the earliest and latest times of the message indexes behind a chunk are those of its
/// header. A recorder's indexes are in order, so their ends suffice; only if these do not match is
/// every entry checked.
bool indexesSpan(const std::vector<mcap::IndexEntries>& indexes, const mcap::Chunk& chunk);

}  // namespace rocinante
