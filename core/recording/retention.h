#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/recording/recorded_files.h"

namespace rocinante {

/// How much of a recording stays.
struct RetentionLimits {
  std::optional<std::uint64_t> keep;              ///< pieces, that which is being written included
  std::optional<std::uint64_t> disk_quota_bytes;  ///< of all pieces together
};

/// Which finished pieces of this recording stay, and which have to go: the oldest. Decides, and
/// deletes nothing. It knows no file but those that were added.
class Retention {
 public:
  explicit Retention(RetentionLimits limits) : limits_(limits) {}

  /// One that was finished after all others.
  void add(PieceFacts piece);
  /// What is known of it now that it is closed.
  void settle(const PieceFacts& piece);

  /// Those that must go while another is being written that holds `current_bytes` (empty: none
  /// is). Each is given once.
  std::vector<PieceFacts> surplus(std::optional<std::uint64_t> current_bytes);
  /// One of those is gone now.
  void countDeleted(const PieceFacts& piece);

  bool holds(const std::filesystem::path& path) const;
  const std::deque<PieceFacts>& kept() const { return kept_; }
  const DeletedPieces& deleted() const { return deleted_; }
  /// Of the pieces kept.
  std::uint64_t bytes() const { return bytes_; }

 private:
  RetentionLimits limits_;
  std::deque<PieceFacts> kept_;
  std::uint64_t bytes_ = 0;
  DeletedPieces deleted_;
};

}  // namespace rocinante
