#pragma once

#include <cstddef>
#include <memory>

#include "core/base/bytes.h"
#include "core/log/log_index.h"
#include "core/log/mapped_file.h"

namespace rocinante {

/// Builds the index by walking over the whole file, record by record. Expands chunks only when
/// their message indexes are not sufficient. Continues after damage. The file must start with the
/// magic. `mapped`: whose bytes these are, if anybody's; its pages are released on the way.
LogIndex indexByWalking(ByteView file, const MappedFile* mapped = nullptr);

/// The same for a file that grows: each record that is complete is walked over once, and only the
/// rest again. The index is changed in place, so that an update costs what is new, however long the
/// log is. Not for sharing between threads.
class GrowingIndex {
 public:
  GrowingIndex();
  ~GrowingIndex();
  GrowingIndex(GrowingIndex&&) noexcept;
  GrowingIndex& operator=(GrowingIndex&&) noexcept;

  /// Makes `index`, which is that of the last call, the index of `file`: this begins at the same
  /// address and with the same bytes, except for chunks that were still open. While it is
  /// `being_written`, what its end cuts is neither read nor lost, except that an open chunk is read
  /// as far as it goes.
  void update(const MappedFile& file, bool being_written, LogIndex& index);
  /// The spans before this one stay as they are in later updates.
  std::size_t settledSpans() const;
  /// The offset from which the next update walks again.
  std::uint64_t settledBytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
