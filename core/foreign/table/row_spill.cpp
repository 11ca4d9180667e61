#include "core/foreign/table/row_spill.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{16} << 20;

}  // namespace

Result<RowSpill> RowSpill::make(const std::string& folder, std::size_t columns) {
  Result<UnnamedFile> file = UnnamedFile::make(folder);
  if (!file) return file.error();
  return RowSpill(std::move(*file), columns);
}

RowSpill::RowSpill(UnnamedFile file, std::size_t columns)
    : file_(std::move(file)),
      columns_(columns),
      block_rows_(std::clamp<std::size_t>(kBlockBytes / (columns * 8), 16, 65536)),
      block_(block_rows_ * columns) {}

Status RowSpill::add(std::span<const std::uint64_t> row) {
  for (std::size_t column = 0; column < columns_; ++column) {
    block_[column * block_rows_ + in_block_] = row[column];
  }
  ++in_block_;
  ++rows_;
  return in_block_ < block_rows_ ? Status{} : writeBlock();
}

Status RowSpill::writeBlock() {
  const ByteView bytes = std::as_bytes(std::span(block_));
  // Called with a whole block of rows.
  Status written = file_.write((rows_ / block_rows_ - 1) * bytes.size(), bytes);
  if (!written) return written;
  in_block_ = 0;
  return {};
}

Status RowSpill::readColumn(std::size_t column, const std::function<Status(ByteView)>& use) {
  const std::uint64_t blocks = rows_ / block_rows_;
  std::vector<std::uint64_t> cells(block_rows_);
  const std::span<std::byte> bytes = std::as_writable_bytes(std::span(cells));
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t from = (block * columns_ + column) * bytes.size();
    if (Status filled = file_.read(from, bytes); !filled) return filled;
    if (Status used = use(bytes); !used) return used;
  }
  const auto last = std::span(block_).subspan(column * block_rows_, in_block_);
  return last.empty() ? Status{} : use(std::as_bytes(last));
}

}  // namespace rocinante
