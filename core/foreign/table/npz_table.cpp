#include <bit>
#include <optional>

#include "core/foreign/table/npy_header.h"
#include "core/foreign/table/row_spill.h"
#include "core/foreign/table/stored_zip.h"
#include "core/foreign/table/table_writer.h"

namespace rocinante {
namespace {

class NpzTable final : public TableWriter {
 public:
  NpzTable(ByteSink& out, std::string folder) : zip_(out), folder_(std::move(folder)) {}

  Status begin(std::span<const std::string> columns) override {
    names_ = {"t", "t_ns"};
    names_.insert(names_.end(), columns.begin(), columns.end());
    Result<RowSpill> rows = RowSpill::make(folder_, names_.size());
    if (!rows) return rows.error();
    rows_.emplace(std::move(*rows));
    cells_.resize(names_.size());
    return {};
  }

  Status row(Nanoseconds time, std::span<const double> values) override {
    cells_[0] = std::bit_cast<std::uint64_t>(secondsOf(time));
    cells_[1] = std::bit_cast<std::uint64_t>(std::int64_t{time.count()});
    for (std::size_t i = 0; i < values.size(); ++i) {
      cells_[i + 2] = std::bit_cast<std::uint64_t>(values[i]);
    }
    return rows_->add(cells_);
  }

  Status end() override {
    for (std::size_t column = 0; column < names_.size(); ++column) {
      const std::string head = npyHeader(column == 1 ? "'<i8'" : "'<f8'", rows_->rows());
      Status written =
          zip_.beginEntry(names_[column] + ".npy", head.size() + rows_->rows() * sizeof(double));
      if (written) written = zip_.append(bytesOf(head));
      if (written) {
        written = rows_->readColumn(column, [&](ByteView cells) { return zip_.append(cells); });
      }
      if (written) written = zip_.endEntry();
      if (!written) return written;
    }
    return zip_.end();
  }

 private:
  StoredZip zip_;
  std::string folder_;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> cells_;  ///< of one row
  std::optional<RowSpill> rows_;
};

}  // namespace

std::unique_ptr<TableWriter> makeNpzTable(ByteSink& out, std::string folder) {
  return std::make_unique<NpzTable>(out, std::move(folder));
}

}  // namespace rocinante
