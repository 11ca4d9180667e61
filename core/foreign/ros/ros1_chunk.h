#pragma once

#include "core/base/result.h"
#include "core/foreign/ros/ros1_record.h"
#include "core/mcap/chunk_expander.h"

namespace rocinante::ros {

/// The records of a chunk (compression none, lz4 or bz2), borrowed from the chunk or `scratch`.
/// damaged when it does not give exactly the size that it claims, or claims more than
/// mcap::kMaxChunkBytes or `budget`; unsupported for a compression that this build lacks.
Result<ByteView> expandRos1Chunk(const Ros1Record& chunk, mcap::ExpansionBudget& budget,
                                 mcap::Scratch& scratch);

}  // namespace rocinante::ros
