#include "core/log/growing_index.h"

namespace rocinante {

void GrowingIndex::keep(const LogIndex& index) {
  tables_ = index;
  spans_ = index.spans.size();
  attachments_ = index.attachments.size();
  metadata_ = index.metadata.size();
  damages_ = index.damage.size();
  last_damage_.reset();
  if (damages_ > 0) last_damage_ = index.damage.back();
}

void GrowingIndex::restore(LogIndex& index) const {
  static_cast<IndexTables&>(index) = tables_;
  index.spans.resize(spans_);
  index.attachments.resize(attachments_);
  index.attachment_offsets.resize(attachments_);
  index.metadata.resize(metadata_);
  index.damage.resize(damages_);
  if (last_damage_) index.damage.back() = *last_damage_;
}

void GrowingIndex::update(const MappedFile& file, bool being_written, LogIndex& index) {
  const ByteView bytes = file.bytes();
  if (bytes.size() > file_bytes_) {
    settled_.budget.grow(bytes.size() - file_bytes_);
    file_bytes_ = bytes.size();
  }
  restore(index);
  IndexWalk walk(bytes, &file, settled_, index);
  walk.runSettled();
  settled_ = walk.place();
  keep(index);
  walk.run(being_written);
}

}  // namespace rocinante
