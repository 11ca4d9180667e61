#include "core/mcap/growing_file.h"

#include <utility>

#include "core/base/hash.h"

namespace rocinante::mcap {

GrowingFile::GrowingFile(std::unique_ptr<ByteSink> sink) : sink_(std::move(sink)) {}

Status GrowingFile::append(ByteView bytes, std::uint64_t tail_bytes) {
  if (Status written = appendUncounted(bytes, tail_bytes); !written) return written;
  crc_ = crc32(bytes, crc_);
  return {};
}

Status GrowingFile::appendUncounted(ByteView bytes, std::uint64_t tail_bytes) {
  if (torn_) {
    return Error{ErrorKind::unreadable, "cannot write after a write that failed", name()};
  }
  if (Status room = reserve_.cover(*sink_, size_ + bytes.size() + tail_bytes); !room) return room;
  if (Status written = sink_->append(bytes); !written) {
    torn_ = !sink_->truncate(size_);
    reserve_.forget();
    // So that the file's end keeps its room while there is any.
    (void)reserve_.cover(*sink_, size_ + tail_bytes);
    return written;
  }
  size_ += bytes.size();
  return {};
}

void GrowingFile::count(std::uint32_t crc, std::uint64_t size_bytes) {
  crc_ = crc32Combine(crc_, crc, size_bytes);
}

Status GrowingFile::overwrite(std::uint64_t offset, ByteView bytes) {
  return sink_->overwriteAt(offset, bytes);
}

Status GrowingFile::settle(std::uint64_t offset) {
  return sink_->startWriteback(offset, size_ - offset);
}

}  // namespace rocinante::mcap
