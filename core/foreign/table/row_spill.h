#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/unnamed_file.h"

namespace rocinante {

/// Rows of eight-byte cells, kept in an unnamed file so that they can be read column by column. One
/// block of rows is in memory.
class RowSpill {
 public:
  /// unreadable when no file can be made in `folder`.
  static Result<RowSpill> make(const std::string& folder, std::size_t columns);

  /// As many cells as columns.
  Status add(std::span<const std::uint64_t> row);
  std::uint64_t rows() const { return rows_; }

  /// Gives the cells of a column in order, in pieces that are borrowed for the call.
  Status readColumn(std::size_t column, const std::function<Status(ByteView)>& use);

 private:
  RowSpill(UnnamedFile file, std::size_t columns);
  Status writeBlock();

  UnnamedFile file_;
  std::size_t columns_;
  std::size_t block_rows_;            ///< of a full block
  std::vector<std::uint64_t> block_;  ///< column after column
  std::size_t in_block_ = 0;          ///< rows
  std::uint64_t rows_ = 0;
};

}  // namespace rocinante
