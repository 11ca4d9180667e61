#include "core/mcap/torn_chunk.h"

#include <fmt/format.h>

#include "core/mcap/chunk_head.h"

namespace rocinante {
namespace {

TornChunk tornAt(const ChunkHead& head, std::uint64_t size, std::string cause) {
  TornChunk torn{head.chunk, head.records_start + size, head.open(), std::move(cause), {}};
  torn.chunk.records = torn.chunk.records.first(static_cast<std::size_t>(size));
  if (torn.cut) {
    torn.chunk.uncompressed_size = mcap::kOpenEnded;
    torn.cause =
        "a chunk was never finished, because its recorder was stopped: its messages are read, "
        "but no checksum covers them";
  }
  return torn;
}

}  // namespace

std::optional<TornChunk> tornChunkAt(ByteView file, std::uint64_t offset, RecordProbe& probe) {
  const std::optional<ChunkHead> head = chunkHeadAt(file, offset);
  if (!head || !knownCompression(head->chunk.compression)) return std::nullopt;
  const ByteView available = head->chunk.records;
  for (const std::uint64_t size : {head->records_bytes, head->recordsByLength()}) {
    if (size == 0 || size > available.size()) continue;
    // The records of that length are whole, or a credible record follows them.
    if (!probe.plausibleAt(head->records_start + size) &&
        !wholeRecords(available.first(static_cast<std::size_t>(size)), head->chunk.compression)) {
      continue;
    }
    TornChunk torn = tornAt(*head, size, "the two lengths of a chunk contradict each other");
    if (!torn.cut) torn.messages_lost = 0;
    return torn;
  }
  if (head->open()) {
    return tornAt(*head, openRecordsBytes(available, head->chunk.compression), {});
  }
  if (head->recordsByLength() != head->records_bytes) return std::nullopt;
  TornChunk torn = tornAt(*head, available.size(),
                          fmt::format("the file ends inside a chunk: {} of its {} bytes are there",
                                      available.size(), head->records_bytes));
  torn.cut = true;
  return torn;
}

}  // namespace rocinante
