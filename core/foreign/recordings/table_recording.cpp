#include "core/foreign/recordings/table_recording.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/figure_text.h"
#include "core/foreign/recordings/line_recording.h"
#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_fields.h"
#include "core/foreign/table/table_header.h"

namespace rocinante {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
/// Of a name or a value in a sentence.
constexpr std::size_t kMaxShown = 64;
/// Of the names that are kept.
constexpr std::size_t kMaxKept = 100'000;
constexpr const char* kTableTopic = "/table";
constexpr const char* kTableDecoder = "csv";

class TableRecording final : public LineRecording {
 public:
  TableRecording(RecordingBytes bytes, std::string name, std::string device)
      : LineRecording(std::move(bytes), std::move(name), kTableTopic, kTableDecoder, "row"),
        device_(std::move(device)) {}

  Status begin() {
    const std::string text = head();
    const std::vector<std::string_view> lines = firstLinesOf(text);
    Result<TableHeader> header = tableHeader(lines);
    const auto first = std::ranges::find_if_not(lines, isTableRemark);
    if (header ? isCut(lines[header->line], text) : first != lines.end() && isCut(*first, text)) {
      return Error{ErrorKind::bad_argument,
                   "the table cannot be read: its header does not end within its first 1 MiB",
                   name()};
    }
    if (!header) {
      return Error{ErrorKind::bad_argument, "the table cannot be read: " + header.error().what,
                   name()};
    }
    header_ = std::move(*header);
    skipLines(header_.line + 1);
    read_ = TableNumbers(header_.separator);
    times_ = TableTimes(header_.unit);
    topic().type = header_.isLong() ? "long table" : "wide table";
    LogSchema schema{"table", kTableDecoder, {}};
    const ByteView line = bytesOf(lines[header_.line]);
    schema.data.assign(line.begin(), line.end());
    topic().schema = std::make_shared<const LogSchema>(std::move(schema));
    if (!header_.isLong()) chooseColumns();
    return {};
  }

  Account account() const override {
    Account account = LineRecording::account();
    const auto leaveOut = [&](std::size_t column, const char* reason, Severity severity) {
      account.leaveOut({.kind = "column",
                        .name = header_.names[column],
                        .reason = reason,
                        .severity = severity});
    };
    if (header_.index != TableHeader::kNone) leaveOut(header_.index, "row numbers", Severity::note);
    for (const ValueColumn& column : columns_) {
      if (column.is_empty) leaveOut(column.place, "no row has a value", Severity::warning);
    }
    if (!header_.isLong()) return account;
    for (std::size_t i = 0; i < header_.names.size(); ++i) {
      if (i == header_.time || i == header_.index || i == header_.device || i == header_.joint ||
          i == header_.value) {
        continue;
      }
      leaveOut(i, "a long table has a device, a joint and a value", Severity::note);
    }
    return account;
  }

 protected:
  bool isRemark(std::string_view line) const override { return isTableRemark(line); }

  std::optional<Row> rowOf(std::string_view line) override {
    const bool is_split = splitCsvLine(line, fields_, header_.separator);
    if (fields_.size() <= header_.time) return std::nullopt;
    const auto time = times_.read(read_.withPoint(fields_[header_.time].text));
    if (!time) return std::nullopt;
    if (!is_split) return Row{*time, {}, "a quote is left open, or text follows one"};
    if (fields_.size() != header_.names.size()) {
      return Row{*time,
                 {},
                 "it has " + countText(fields_.size(), "column") + ", the header " +
                     std::to_string(header_.names.size())};
    }
    return header_.isLong() ? valueRow(*time) : wideRow(*time);
  }

 private:
  /// Of a line of head(): whether it goes on behind it.
  bool isCut(std::string_view line, std::string_view head) const {
    return !isHeadWhole() && line.data() + line.size() == head.data() + head.size();
  }

  /// A column of the wide form that may have values.
  struct ValueColumn {
    std::size_t place = 0;
    bool is_empty = true;   ///< nothing but "no value" so far
    bool is_words = false;  ///< its first value is no number that a joint can have: a signal's
  };

  Row translated(Nanoseconds time) {
    const RowTranslation::Outcome outcome = rows().translate(time, numbers_, words_);
    if (outcome.malformed) return {time, {}, kPartOfPoseAlone};
    return {time, outcome.packet};
  }

  /// Of a row with text where the others have numbers.
  Row noNumber(Nanoseconds time, std::size_t column) const {
    return {time,
            {},
            "column `" + header_.names[column].substr(0, kMaxShown) + "` has `" +
                std::string(fields_[column].text.substr(0, kMaxShown)) + "`, which is no number"};
  }

  void chooseColumns() {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < header_.names.size(); ++i) {
      if (i == header_.time || i == header_.index) continue;
      columns_.push_back({i});
      names.push_back(header_.names[i]);
    }
    names_.assign(names.begin(), names.end());
  }

  Row wideRow(Nanoseconds time) {
    // Here the devices are known.
    if (numbers_.empty()) rows().setNames(names_);
    numbers_.clear();
    words_.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      ValueColumn& column = columns_[i];
      double number = kNothing;
      const TableValue value = read_.read(fields_[column.place].text, number);
      if (value == TableValue::nothing) number = kNothing;
      if (value == TableValue::text || (column.is_words && value == TableValue::number)) {
        column.is_words |= column.is_empty;
        if (!column.is_words && !rows().isSignal(i)) return noNumber(time, column.place);
        number = kNothing;
        addWord(i, column.place);
      }
      column.is_empty &= value == TableValue::nothing;
      numbers_.push_back(number);
    }
    return translated(time);
  }

  void addWord(std::size_t place, std::size_t column) {
    auto value = read_.readSignal(fields_[column].unescaped());
    if (value) words_.push_back({place, std::move(*value)});
  }

  Row valueRow(Nanoseconds time) {
    double number = 0;
    const TableValue value = read_.read(fields_[header_.value].text, number);
    if (value == TableValue::nothing) return {time, {}};
    words_.clear();
    numbers_.assign(1, value == TableValue::number ? number : kNothing);
    std::string name;
    if (header_.device != TableHeader::kNone) name = fields_[header_.device].unescaped();
    if (name.empty()) name = device_;
    if (!name.empty()) name += '.';
    name += fields_[header_.joint].unescaped();
    rows().setNames(std::span<const std::string>(&name, 1));
    if (value == TableValue::text) {
      if (!rows().isSignal(0) && with_numbers_.contains(name)) return noNumber(time, header_.value);
      addWord(0, header_.value);
    } else if (with_numbers_.size() < kMaxKept) {
      with_numbers_.insert(std::move(name));
    }
    return translated(time);
  }

  std::string device_;
  TableHeader header_;
  TableNumbers read_{','};
  TableTimes times_{TimeUnit::unknown};
  std::vector<CsvField> fields_;  ///< of the current line
  std::vector<ValueColumn> columns_;
  std::vector<std::string> names_;  ///< as many
  std::vector<double> numbers_;
  std::vector<RowTranslation::Word> words_;
  std::set<std::string> with_numbers_;  ///< names of the long form
};

Result<std::unique_ptr<ros::BagReader>> tableOf(RecordingBytes bytes, std::string name,
                                                const std::string& device) {
  auto table = std::make_unique<TableRecording>(std::move(bytes), std::move(name), device);
  if (Status begun = table->begin(); !begun) return begun.error();
  return std::unique_ptr<ros::BagReader>(std::move(table));
}

}  // namespace

bool looksLikeTable(std::string_view text) { return tableHeader(firstLinesOf(text)).ok(); }

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
