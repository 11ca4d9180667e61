#include "core/log/chunk_indexes.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rocinante {

bool indexesSpan(const std::vector<mcap::IndexEntries>& indexes, const mcap::Chunk& chunk) {
  if (indexes.empty()) return false;
  for (const bool all : {false, true}) {
    std::uint64_t start = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t end = 0;
    for (const mcap::IndexEntries& index : indexes) {
      const std::size_t stride = all ? 1 : std::max<std::size_t>(index.size() - 1, 1);
      for (std::size_t i = 0; i < index.size(); i += stride) {
        start = std::min(start, index.time(i));
        end = std::max(end, index.time(i));
      }
    }
    if (start == chunk.message_start_time && end == chunk.message_end_time) return true;
  }
  return false;
}

}  // namespace rocinante
