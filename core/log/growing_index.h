#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/log/log_index.h"
#include "core/log/log_index_walk.h"
#include "core/log/mapped_file.h"

namespace rocinante {

/// The index of a file that grows: each record that is complete is walked over once, and only the
/// rest again. The index is changed in place, so that an update costs what is new, however long the
/// log is. Not for sharing between threads.
class GrowingIndex {
 public:
  /// Makes `index`, which is that of the last call, the index of `file`: this begins at the same
  /// address and with the same bytes, except for chunks that were still open. While it is
  /// `being_written`, what its end cuts is neither read nor lost, except that an open chunk is read
  /// as far as it goes.
  void update(const MappedFile& file, bool being_written, LogIndex& index);
  /// The spans before this one stay as they are in later updates.
  std::size_t settledSpans() const { return spans_; }
  /// The offset from which the next update walks again.
  std::uint64_t settledBytes() const { return settled_.position; }

 private:
  void keep(const LogIndex& index);
  void restore(LogIndex& index) const;

  WalkPlace settled_;             ///< behind the last record that stays as it is
  std::uint64_t file_bytes_ = 0;  ///< of the longest file so far
  // What the index held there.
  IndexTables tables_;
  std::size_t spans_ = 0;
  std::size_t attachments_ = 0;
  std::size_t metadata_ = 0;
  std::size_t damages_ = 0;
  std::optional<DamageSpan> last_damage_;  ///< a later one may lengthen it
};

}  // namespace rocinante
