#include <cmath>
#include <cstdint>

#include "core/foreign/table/table_writer.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// Handed over in pieces of about this size.
constexpr std::size_t kCsvPieceBytes = 1U << 16U;

void appendField(std::string& text, std::string_view field) {
  const bool is_plain = field.find_first_of("\",\r\n") == field.npos && !field.empty() &&
                        field.front() != ' ' && field.back() != ' ';
  if (is_plain) {
    text += field;
    return;
  }
  text += '"';
  for (const char byte : field) {
    if (byte == '"') text += '"';
    text += byte;
  }
  text += '"';
}

class CsvTable final : public TableWriter {
 public:
  explicit CsvTable(AppendBytes out) : out_(std::move(out)) {}

  Status begin(std::span<const std::string> columns) override {
    piece_ = "t";
    for (const std::string& column : columns) {
      piece_ += ',';
      appendField(piece_, column);
    }
    piece_ += '\n';
    return {};
  }

  Status row(Nanoseconds time, std::span<const double> values) override {
    if (time.count() < 0) piece_ += '-';
    appendSeconds(piece_, std::abs(time.count()));
    for (const double value : values) {
      piece_ += ',';
      if (!std::isnan(value)) appendNumber(piece_, value);
    }
    piece_ += '\n';
    return piece_.size() < kCsvPieceBytes ? Status{} : handOver();
  }

  Status end() override { return handOver(); }

 private:
  Status handOver() {
    Status written = out_(bytesOf(piece_));
    piece_.clear();
    return written;
  }

  AppendBytes out_;
  std::string piece_;
};

}  // namespace

std::unique_ptr<TableWriter> makeCsvTable(AppendBytes out) {
  return std::make_unique<CsvTable>(std::move(out));
}

}  // namespace rocinante
