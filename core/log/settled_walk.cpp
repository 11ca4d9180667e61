// What of a file that grows stays as it is.
#include "core/log/log_index_walk.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {

using mcap::Opcode;

void IndexWalk::runSettled() {
  while (at_.position < file_.size()) {
    const bool is_whole = settledAt(at_.position);
    const bool is_taken = is_whole && takeRecord();
    if (!is_taken && !takeSettledDamage(is_whole)) return;
    releasePages();
  }
}

bool IndexWalk::settledAt(std::uint64_t position) const {
  const std::optional<mcap::Record> record = mcap::recordAt(file_, position);
  if (!record || record->opcode == Opcode::data_end) return false;
  if (record->opcode != Opcode::chunk) return true;
  const std::optional<ChunkHead> head = chunkHeadAt(file_, position);
  return head && !head->open() && mcap::recordAt(file_, record->end());
}

bool IndexWalk::takeSettledDamage(bool is_whole) {
  const std::uint64_t from = at_.position;
  if (!is_whole) {
    const auto head = chunkHeadAt(file_, from);
    if (mcap::recordAt(file_, from) || cutAt(from) || (head && head->open())) return false;
    if (const auto torn = tornChunkAt(file_, from, probe_)) {
      return followedAt(torn->end) && takeTornChunk();
    }
  }
  const std::uint64_t next = probe_.resumeBehind(from);
  if (!followedAt(next)) return false;
  for (std::uint64_t between = from + 1; between < next; ++between) {
    if (mayGrowAt(between)) return false;
  }
  skipDamage(next);
  return true;
}

bool IndexWalk::followedAt(std::uint64_t position) const {
  if (position >= file_.size() || !settledAt(position)) return false;
  return mcap::recordAt(file_, mcap::recordAt(file_, position)->end()).has_value();
}

bool IndexWalk::mayGrowAt(std::uint64_t position) const {
  const auto opcode = std::to_integer<std::uint8_t>(file_[static_cast<std::size_t>(position)]);
  if (opcode == 0 || opcode > static_cast<std::uint8_t>(Opcode::data_end)) return false;
  const std::optional<mcap::Record> record = mcap::recordAt(file_, position);
  if (!record) return cutAt(position);
  return !mcap::recordAt(file_, record->end()) && cutAt(record->end());
}

}  // namespace rocinante
