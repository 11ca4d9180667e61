#include "core/foreign/recordings/table_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/foreign/recordings/line_recording.h"
#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_column.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxColumns = 100'000;
/// Numbers of packet text are below.
constexpr double kTableBound = 0x1p53;
constexpr const char* kTableTopic = "/table";
constexpr const char* kTableDecoder = "csv";

bool isTimeName(std::string_view name) {
  return name == "t" || name == "time" || name == "t_ns" || name == "time_ns";
}

std::optional<double> numberIn(std::string_view text) {
  double number = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  if (!readNumber(at, end, number) || at != end || !(std::abs(number) < kTableBound)) {
    return std::nullopt;
  }
  return number;
}

/// What the header says of each column.
struct TableHeader {
  std::vector<std::string> names;
  std::size_t time = kNoColumn;
  bool is_ns = false;
  /// Of the long form.
  std::size_t device = kNoColumn, joint = kNoColumn, value = kNoColumn;

  bool isLong() const { return joint != kNoColumn && value != kNoColumn; }
};

std::optional<TableHeader> tableHeader(std::string_view line) {
  std::vector<CsvField> fields;
  if (!splitCsvLine(line, fields) || fields.size() < 2 || fields.size() > kMaxColumns) {
    return std::nullopt;
  }
  TableHeader header;
  for (const CsvField& field : fields) {
    header.names.push_back(field.unescaped());
    const std::string& name = header.names.back();
    const bool is_plain = std::ranges::none_of(
        name, [](char byte) { return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F; });
    if (name.empty() || !is_plain) return std::nullopt;
  }
  const auto find = [&](std::string_view wanted) {
    const auto found = std::ranges::find(header.names, wanted);
    return found == header.names.end() ? kNoColumn
                                       : static_cast<std::size_t>(found - header.names.begin());
  };
  // Nanoseconds are exact where both are given.
  for (const char* const name : {"time", "t", "time_ns", "t_ns"}) {
    if (find(name) == kNoColumn) continue;
    header.time = find(name);
    header.is_ns = std::string_view(name).ends_with("_ns");
  }
  if (header.time == kNoColumn) return std::nullopt;
  header.device = find("device");
  header.joint = find("joint") != kNoColumn ? find("joint") : find("name");
  header.value = find("value") != kNoColumn ? find("value") : find("position");
  return header;
}

class TableRecording final : public LineRecording {
 public:
  TableRecording(RecordingBytes bytes, std::string name, std::string device)
      : LineRecording(std::move(bytes), std::move(name), kTableTopic, kTableDecoder, "row"),
        device_(std::move(device)) {}

  Status begin() {
    const std::optional<std::string_view> line = firstLine();
    std::optional<TableHeader> header = line ? tableHeader(*line) : std::nullopt;
    if (!header) {
      return Error{ErrorKind::bad_argument,
                   "the first line is not a header with a column `t` or `time`", name()};
    }
    header_ = std::move(*header);
    topic().type = header_.isLong() ? "long table" : "wide table";
    LogSchema schema{"table", kTableDecoder, {}};
    const ByteView text = bytesOf(*line);
    schema.data.assign(text.begin(), text.end());
    topic().schema = std::make_shared<const LogSchema>(std::move(schema));
    return {};
  }

 protected:
  std::optional<Row> rowOf(std::string_view line) override {
    const bool is_split = splitCsvLine(line, fields_);
    const std::optional<Nanoseconds> time = timeOf();
    if (!time) return std::nullopt;
    if (!is_split || fields_.size() != header_.names.size()) return Row{*time, {}, true};
    return header_.isLong() ? valueRow(*time) : wideRow(*time);
  }

 private:
  std::optional<Nanoseconds> timeOf() const {
    if (fields_.size() <= header_.time) return std::nullopt;
    const std::string_view text = fields_[header_.time].text;
    if (!header_.is_ns) return tableSeconds(text);
    const std::optional<std::uint64_t> count = readUnsigned(text);
    if (!count || *count > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
      return std::nullopt;
    }
    return Nanoseconds(static_cast<std::int64_t>(*count));
  }

  Row translated(Nanoseconds time) {
    const RowTranslation::Outcome outcome = rows().translate(time, numbers_);
    return {time, outcome.malformed ? std::string_view() : outcome.packet, outcome.malformed};
  }

  /// Columns whose first field is text are remarks; the others are values from then on.
  void chooseColumns() {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const bool is_time = i == header_.time || isTimeName(header_.names[i]);
      if (is_time || (!fields_[i].text.empty() && !numberIn(fields_[i].text))) continue;
      columns_.push_back(i);
      names.push_back(header_.names[i]);
    }
    rows().setNames(names);
    chosen_ = true;
  }

  Row wideRow(Nanoseconds time) {
    if (!chosen_) chooseColumns();
    numbers_.clear();
    for (const std::size_t column : columns_) {
      const std::string_view text = fields_[column].text;
      const std::optional<double> number = text.empty() ? kNothing : numberIn(text);
      if (!number) return {time, {}, true};
      numbers_.push_back(*number);
    }
    return translated(time);
  }

  Row valueRow(Nanoseconds time) {
    const std::optional<double> number = numberIn(fields_[header_.value].text);
    if (!number) return {time, {}, true};
    numbers_.assign(1, *number);
    std::string name;
    if (header_.device != kNoColumn) name = fields_[header_.device].unescaped();
    if (name.empty()) name = device_;
    if (!name.empty()) name += '.';
    name += fields_[header_.joint].unescaped();
    rows().setNames(std::span<const std::string>(&name, 1));
    return translated(time);
  }

  std::string device_;
  TableHeader header_;
  std::vector<CsvField> fields_;      ///< of the current line
  std::vector<std::size_t> columns_;  ///< of the wide form: those with values
  bool chosen_ = false;
  std::vector<double> numbers_;
};

Result<std::unique_ptr<ros::BagReader>> tableOf(RecordingBytes bytes, std::string name,
                                                const std::string& device) {
  auto table = std::make_unique<TableRecording>(std::move(bytes), std::move(name), device);
  if (Status begun = table->begin(); !begun) return begun.error();
  return std::unique_ptr<ros::BagReader>(std::move(table));
}

}  // namespace

bool looksLikeTable(std::string_view text) {
  RecordingLines lines{RecordingBytes(bytesOf(text))};
  const auto line = lines.next();
  return line && tableHeader(*line).has_value();
}

Result<std::unique_ptr<ros::BagReader>> openTable(const std::filesystem::path& path,
                                                  const std::string& device) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  return tableOf(RecordingBytes(std::move(*file)), path.string(), device);
}

Result<std::unique_ptr<ros::BagReader>> openTableBytes(ByteView bytes, std::string name,
                                                       const std::string& device) {
  return tableOf(RecordingBytes(bytes), std::move(name), device);
}

}  // namespace rocinante
