// Any bytes as the records of a chunk, stored plain or as zstd, its header whole, open or lying
// about the size: alone through the expander, and as the one chunk of a log. Nothing may crash,
// hang or take memory without bound, and both directions give the same messages.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "core/mcap/append_record.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/records.h"

namespace {

using namespace rocinante;

/// From the first byte: how the chunk is stored, and what its header says.
mcap::Chunk chunkOf(std::uint8_t kind, ByteView records) {
  mcap::Chunk chunk;
  chunk.compression = (kind & 1U) != 0 ? "zstd" : "";
  chunk.message_start_time = 1000;
  chunk.message_end_time = (kind & 2U) != 0 ? mcap::kOpenEnded : 2000;
  chunk.uncompressed_size = (kind & 4U) != 0   ? mcap::kOpenEnded
                            : (kind & 8U) != 0 ? std::uint64_t{1} << 16U
                                               : records.size();
  if ((kind & 16U) != 0 && chunk.compression.empty()) chunk.uncompressed_crc = crc32(records);
  chunk.records = records;
  return chunk;
}

std::vector<LogPosition> places(LogReader& reader, bool backwards) {
  std::vector<LogPosition> out;
  while (const std::optional<LogMessage> message =
             backwards ? *reader.previous() : *reader.next()) {
    out.push_back(message->place());
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ByteView records(reinterpret_cast<const std::byte*>(data) + 1, size - 1);
  const mcap::Chunk chunk = chunkOf(data[0], records);

  mcap::ChunkExpander expander;
  mcap::Scratch scratch;
  const Result<ByteView> whole = expander.expand(chunk, scratch);
  if (whole && whole->size() != chunk.uncompressed_size) std::abort();
  const Result<ByteView> cut = expander.expandCut(chunk, scratch);
  if (cut && cut->size() > mcap::kMaxChunkBytes) std::abort();

  Bytes file(mcap::magic().begin(), mcap::magic().end());
  append(file, mcap::Header{"rocinante", ""});
  append(file, mcap::Channel{0, 0, "/udp/1/a", "octets", {}});
  const std::size_t head = file.size();
  append(file, chunk);
  if ((data[0] & 32U) != 0) {
    std::memset(file.data() + head + 1, 0xFF, sizeof(std::uint64_t));
    std::memset(file.data() + file.size() - records.size() - sizeof(std::uint64_t), 0xFF,
                sizeof(std::uint64_t));
  }
  Result<LogReader> reader = LogReader::openBytes(file, "fuzz");
  if (!reader) std::abort();
  const std::vector<LogPosition> forwards = places(*reader, false);
  const std::vector<LogPosition> backwards = places(*reader, true);
  if (!std::equal(forwards.begin(), forwards.end(), backwards.rbegin(), backwards.rend())) {
    std::abort();
  }
  (void)reader->lastOf(0, LogTime(Nanoseconds(1500)));
  return 0;
}
