#include "core/foreign/bytes/little_endian.h"
#include "core/foreign/table/npy_header.h"
#include "core/foreign/table/table_writer.h"

namespace rocinante {
namespace {

/// Handed over in pieces of about this size.
constexpr std::size_t kNpyPieceBytes = 1U << 16U;

class NpyTable final : public TableWriter {
 public:
  explicit NpyTable(ByteSink& out) : out_(out) {}

  Status begin(std::span<const std::string> columns) override {
    fields_ = "[('t', '<f8'), ('t_ns', '<i8')";
    for (const std::string& column : columns) fields_ += ", (" + pythonText(column) + ", '<f8')";
    fields_ += "]";
    if (fields_.size() > kMaxNpyHeaderBytes) {
      return Error{ErrorKind::unsupported, "the names of the columns exceed 64 MiB", out_.name()};
    }
    return out_.append(bytesOf(npyHeader(fields_, 0)));
  }

  Status row(Nanoseconds time, std::span<const double> values) override {
    appendLittle(piece_, secondsOf(time));
    appendLittle(piece_, std::int64_t{time.count()});
    appendBytes(piece_, std::as_bytes(values));
    ++rows_;
    return piece_.size() < kNpyPieceBytes ? Status{} : handOver();
  }

  Status end() override {
    if (Status written = handOver(); !written) return written;
    return out_.overwriteAt(0, bytesOf(npyHeader(fields_, rows_)));
  }

 private:
  Status handOver() {
    Status written = out_.append(piece_);
    piece_.clear();
    return written;
  }

  ByteSink& out_;
  std::string fields_;
  std::uint64_t rows_ = 0;
  Bytes piece_;
};

}  // namespace

std::unique_ptr<TableWriter> makeNpyTable(ByteSink& out) { return std::make_unique<NpyTable>(out); }

}  // namespace rocinante
