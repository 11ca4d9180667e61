#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/recording/recorded_files.h"

namespace rocinante {

/// How much of a recording is kept.
struct RetentionLimits {
  std::optional<std::uint64_t> keep{};              ///< pieces, including the one being written
  std::optional<std::uint64_t> disk_quota_bytes{};  ///< of all pieces together
  std::optional<Nanoseconds> span{};                ///< of log time, back from what was reached
};

/// Decides which finished pieces of this recording stay and which must go: the oldest. Deletes
/// nothing itself, and knows only the pieces that were added.
class Retention {
 public:
  explicit Retention(RetentionLimits limits) : limits_(limits) {}

  /// Adds the piece that was finished last.
  void add(PieceFacts piece);
  /// Updates a piece with its facts after closing.
  void settle(const PieceFacts& piece);

  /// The pieces that must go while another one of `current_bytes` is being written (empty: none
  /// is). Each is returned once. `reached` is the log time by which a piece may be too old.
  std::vector<PieceFacts> surplus(std::optional<std::uint64_t> current_bytes,
                                  std::optional<LogTime> reached = std::nullopt);
  /// One of those is deleted now.
  void countDeleted(const PieceFacts& piece);

  bool holds(const std::filesystem::path& path) const;
  const std::deque<PieceFacts>& kept() const { return kept_; }
  const DeletedPieces& deleted() const { return deleted_; }
  /// Size of the pieces kept.
  std::uint64_t bytes() const { return bytes_; }

 private:
  RetentionLimits limits_;
  std::deque<PieceFacts> kept_;
  std::uint64_t bytes_ = 0;
  DeletedPieces deleted_;
};

}  // namespace rocinante
