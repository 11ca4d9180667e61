#include "player/source/csv_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_column.h"
#include "core/foreign/table/table_fields.h"
#include "core/foreign/table/table_header.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// "0x12", "1.2.3", "4e": meant as a number.
bool beginsAsNumber(std::string_view text) {
  const std::size_t first = text.find_first_not_of("+-.,");
  return first != text.npos && text[first] >= '0' && text[first] <= '9';
}

/// A field for an error message, shortened.
std::string shown(std::string_view text) {
  constexpr std::size_t kShownBytes = 40;
  if (text.empty()) return "an empty field";
  return text.size() <= kShownBytes ? fmt::format("`{}`", text)
                                    : fmt::format("`{}...`", text.substr(0, kShownBytes));
}

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Reads one text; keeps its position for error messages.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Result<CsvMotion> read(const std::string& device, const std::vector<std::string>& columns) {
    // A byte order mark is not part of the first column's name.
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (const Status header = readHeader(); !header) return header.error();
    if (const Status chosen = chooseColumns(columns, device); !chosen) return chosen.error();
    if (const Status shared = shareOut(device); !shared) return shared.error();
    latest_.assign(columns_at_.size(), kNoValue);
    bool states_anything = false;
    while (nextLine()) {
      if (const Status row = readRow(); !row) return row.error();
      const auto row = motion_.row(motion_.rowCount() - 1);
      states_anything |= std::ranges::any_of(row, [](double each) { return !std::isnan(each); });
    }
    if (motion_.times.empty()) return fault("there is no row below the header", 1);
    states_anything |= !motion_.signals.changes().empty();
    if (!states_anything) return fault("no row has a value for all joints of a device", 1);
    return std::move(motion_);
  }

 private:
  /// The next line that is a row.
  bool nextLine() {
    while (const auto line = takeLine(rest_)) {
      ++line_;
      if (isTableRemark(*line)) continue;
      split_ = splitCsvLine(*line, fields_, header_.separator);
      return true;
    }
    return false;
  }

  Error fault(std::string what, std::size_t column) const {
    return {ErrorKind::bad_argument, std::move(what),
            fmt::format("{}, line {}, column {}", name_, line_, column)};
  }
  Error badQuotes() const { return fault("a quoted field is not closed", fields_.back().column); }
  const std::vector<std::string>& names() const { return header_.names; }
  void leaveOut(std::size_t column, std::string_view reason, Severity severity) {
    motion_.left_out.leaveOut({.kind = "column",
                               .name = names()[column],
                               .reason = std::string(reason),
                               .severity = severity});
  }

  Status readHeader();
  Status chooseColumns(const std::vector<std::string>& columns, const std::string& device);
  void findSignals(const std::string& device, bool are_chosen);
  NamedSignal signalOf(std::string_view name, const std::string& device) const;
  Status shareOut(const std::string& device);
  void shareOutAlone(const std::string& device);
  Status addColumn(std::size_t index);
  Status readRow();
  Result<double> numberOf(const CsvField& field, const std::string& column);
  Status fillGaps(std::span<double> row);

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 0;
  TableHeader header_;
  TableNumbers read_{','};
  TableTimes times_{TimeUnit::unknown};
  std::vector<CsvField> fields_;  ///< of the current line
  bool split_ = true;

  std::vector<std::size_t> columns_at_;
  std::vector<double> latest_;  ///< values of those columns so far
  CsvMotion motion_;
};

Status Reader::readHeader() {
  const std::vector<std::string_view> lines = firstLinesOf(rest_);
  if (std::ranges::all_of(lines, isTableRemark)) {
    return Error{ErrorKind::bad_argument, "the file has no header row", name_};
  }
  Result<TableHeader> header = tableHeader(lines);
  if (!header) return Error{ErrorKind::bad_argument, header.error().what, name_};
  header_ = std::move(*header);
  for (std::size_t i = 0; i <= header_.line; ++i) {
    takeLine(rest_);
    ++line_;
  }
  read_ = TableNumbers(header_.separator);
  times_ = TableTimes(header_.unit);
  for (std::size_t i = 0; i < names().size(); ++i) {
    const std::string& name = names()[i];
    if (name.size() > limits::kNameBytes) {
      return fault(fmt::format("the name of column {} is longer than 255 bytes", i + 1), 1);
    }
    if (std::find(names().begin(), names().begin() + static_cast<std::ptrdiff_t>(i), name) !=
        names().begin() + static_cast<std::ptrdiff_t>(i)) {
      return fault(fmt::format("two columns are named {}", shown(name)), 1);
    }
  }
  return {};
}

Status Reader::chooseColumns(const std::vector<std::string>& columns, const std::string& device) {
  if (columns.empty()) {
    for (std::size_t i = 0; i < names().size(); ++i) {
      if (i == header_.time) continue;
      if (i == header_.index) {
        leaveOut(i, "row numbers", Severity::note);
      } else if (const std::string_view reason = notAValue(names()[i]); !reason.empty()) {
        leaveOut(i, reason, Severity::note);
      } else {
        columns_at_.push_back(i);
      }
    }
  }
  for (const std::string& wanted : columns) {
    const auto found = std::find(names().begin(), names().end(), wanted);
    if (found == names().end()) {
      return fault(fmt::format("no column is named {}", shown(wanted)), 1);
    }
    const auto at = static_cast<std::size_t>(found - names().begin());
    if (std::find(columns_at_.begin(), columns_at_.end(), at) != columns_at_.end()) {
      return fault(fmt::format("column {} is chosen twice", shown(wanted)), 1);
    }
    columns_at_.push_back(at);
  }
  findSignals(device, !columns.empty());
  if (columns_at_.empty() && motion_.signals.columns().empty())
    return fault("the table has no joint column", 1);
  motion_.column_count = columns_at_.size();
  return {};
}

/// What a column that is no joint states.
NamedSignal Reader::signalOf(std::string_view name, const std::string& device) const {
  const auto column = tableColumn(name);
  if (column && !column->quantity.empty()) {
    return {device, {"", std::string(column->joint) + std::string(column->quantity)}};
  }
  const bool is_of_device = column && !column->pose_part && !column->device.empty();
  if (!device.empty() || !is_of_device) return {device, {"", std::string(name)}};
  return {std::string(column->device), {"", std::string(column->joint)}};
}

/// Takes the columns of signals from the others: those that are named so, and those whose first
/// value is no number. Those without a value have nothing to send.
void Reader::findSignals(const std::string& device, bool are_chosen) {
  const auto rest = rest_;
  const auto line = line_;
  TableNumbers read = read_;
  std::vector<bool> is_taken(names().size());
  const auto leaveColumnOut = [&](std::size_t column, std::string_view reason) {
    leaveOut(column, reason, tableColumn(names()[column]) ? Severity::warning : Severity::note);
    is_taken[column] = true;
  };
  const auto addSignal = [&](std::size_t column, NamedSignal signal) {
    const std::string_view refused = motion_.signals.add(std::move(signal), column);
    if (!refused.empty()) leaveOut(column, refused, Severity::warning);
    is_taken[column] = true;
  };
  for (const std::size_t column : columns_at_) {
    if (isSignalColumn(names()[column])) {
      addSignal(column, signalNamed(names()[column]).value_or(NamedSignal()));
    } else if (const auto words = tableColumn(names()[column]); words && !words->quantity.empty()) {
      addSignal(column, signalOf(names()[column], device));
    }
  }
  const auto isTaken = [&](std::size_t column) { return is_taken[column]; };
  std::erase_if(columns_at_, isTaken);
  std::vector<std::size_t> undecided = columns_at_;
  bool has_rows = false;
  while (!undecided.empty() && nextLine()) {
    if (!split_ || fields_.size() != names().size()) break;  // readRow() says so
    has_rows = true;
    std::erase_if(undecided, [&](std::size_t column) {
      double ignored = 0;
      const TableValue value = read.read(fields_[column].text, ignored);
      // A number of another kind is a fault, which readRow() names.
      const bool is_text = value == TableValue::text && !beginsAsNumber(fields_[column].text);
      if (is_text) addSignal(column, signalOf(names()[column], device));
      return value != TableValue::nothing;
    });
  }
  if (has_rows && rest_.empty() && !are_chosen) {
    for (const std::size_t column : undecided) leaveColumnOut(column, "no row has a value");
  }
  std::erase_if(columns_at_, isTaken);
  rest_ = rest;
  line_ = line;
}

/// Finds the device of a column by its name, or adds it.
CsvMotion::Device& deviceNamed(CsvMotion& motion, std::string_view name) {
  for (CsvMotion::Device& device : motion.devices) {
    if (device.name == name) return device;
  }
  return motion.devices.emplace_back(CsvMotion::Device{std::string(name), {}, {}, {}});
}

Status Reader::addColumn(std::size_t index) {
  const std::string_view name = names()[columns_at_[index]];
  const auto column = tableColumn(name);
  if (!column || column->device.empty()) {
    return fault(fmt::format("column {} names no device: without --device a column is DEVICE.JOINT "
                             "or DEVICE:x, :y, :z, :qx, :qy, :qz, :qw",
                             shown(name)),
                 1);
  }
  CsvMotion::Device& device = deviceNamed(motion_, column->device);
  if (column->pose_part) {
    device.pose_columns.resize(kPoseEndings.size(), TableHeader::kNone);
    device.pose_columns[*column->pose_part] = index;
    return {};
  }
  device.joints.emplace_back(column->joint);
  device.joint_columns.push_back(index);
  return {};
}

/// All columns are about one device: joints, or a pose as TUM writes it.
void Reader::shareOutAlone(const std::string& device) {
  CsvMotion::Device& only = deviceNamed(motion_, device);
  std::vector<std::size_t> pose(kPoseEndings.size(), TableHeader::kNone);
  for (std::size_t i = 0; i < columns_at_.size(); ++i) {
    if (const auto part = plainPosePart(names()[columns_at_[i]])) pose[*part] = i;
  }
  if (std::ranges::find(pose, TableHeader::kNone) == pose.end()) only.pose_columns = pose;
  for (std::size_t i = 0; i < columns_at_.size(); ++i) {
    if (std::ranges::find(only.pose_columns, i) != only.pose_columns.end()) continue;
    const std::string& name = names()[columns_at_[i]];
    const auto column = tableColumn(name);
    only.joints.emplace_back(column && !column->topic.empty() ? column->joint : name);
    only.joint_columns.push_back(i);
  }
}

Status Reader::shareOut(const std::string& device) {
  if (!device.empty()) shareOutAlone(device);
  for (std::size_t i = 0; i < columns_at_.size() && device.empty(); ++i) {
    if (const Status added = addColumn(i); !added) return added;
  }
  for (const CsvMotion::Device& each : motion_.devices) {
    for (std::size_t part = 0; part < each.pose_columns.size(); ++part) {
      if (each.pose_columns[part] < columns_at_.size()) continue;
      const std::string missing = each.name + std::string(kPoseEndings[part]);
      return fault(fmt::format("a pose needs seven columns: {} is missing", shown(missing)), 1);
    }
    if (each.joints.size() > limits::kJointValues) {
      return fault(fmt::format("{} joints of {}, but a packet holds at most {}", each.joints.size(),
                               shown(each.name), limits::kJointValues),
                   1);
    }
  }
  return {};
}

/// NaN: the field has no value.
Result<double> Reader::numberOf(const CsvField& field, const std::string& column) {
  double number = 0;
  switch (read_.read(field.text, number)) {
    case TableValue::number:
      return number;
    case TableValue::nothing:
      return kNoValue;
    case TableValue::text:
      break;
  }
  const char* read = field.text.data();
  const char* const end = read + field.text.size();
  if (!readNumber(read, end, number) || read != end) {
    return fault(fmt::format("{} is not a number that packet text allows, in {}", shown(field.text),
                             shown(column)),
                 field.column);
  }
  return fault(fmt::format("{} is not below 2^53, in {}", shown(field.text), shown(column)),
               field.column);
}

Status Reader::readRow() {
  if (!split_) return badQuotes();
  if (fields_.size() != names().size()) {
    return fault(
        fmt::format("the row has {} fields, the header has {}", fields_.size(), names().size()),
        fields_.back().column);
  }
  const CsvField& moment = fields_[header_.time];
  const auto time = times_.read(read_.withPoint(moment.text));
  if (!time) return fault(fmt::format("{} is not a time", shown(moment.text)), moment.column);
  if (!motion_.times.empty() && *time < motion_.times.back()) {
    return fault(fmt::format("the time goes back: {} follows a later time", shown(moment.text)),
                 moment.column);
  }
  const auto& signals = motion_.signals.columns();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const std::size_t at = signals[i].column;
    auto value = read_.readSignal(fields_[at].unescaped());
    if (value && !motion_.signals.say(motion_.rowCount(), i, *value)) {
      motion_.left_out.leaveOut({.kind = "value",
                                 .name = names()[at],
                                 .reason = std::string(kNoSignalText),
                                 .first = fmt::format("line {}", line_),
                                 .severity = Severity::warning});
    }
  }
  for (const std::size_t at : columns_at_) {
    const Result<double> number = numberOf(fields_[at], names()[at]);
    if (!number) return number.error();
    motion_.numbers.push_back(*number);
  }
  motion_.times.push_back(*time);
  return fillGaps(std::span(motion_.numbers).last(columns_at_.size()));
}

/// A device's joints are said together: one without a value keeps its last one, and until each has
/// one nothing is said. A pose is whole or missing.
Status Reader::fillGaps(std::span<double> row) {
  for (const CsvMotion::Device& device : motion_.devices) {
    const auto has_value = [&](std::size_t column) { return !std::isnan(row[column]); };
    const bool has_news = std::ranges::any_of(device.joint_columns, has_value);
    for (const std::size_t column : device.joint_columns) {
      if (has_value(column)) latest_[column] = row[column];
      if (has_news) row[column] = latest_[column];
    }
    if (!std::ranges::all_of(device.joint_columns, has_value)) {
      for (const std::size_t column : device.joint_columns) row[column] = kNoValue;
    }
    const bool is_stated = hasValues(row, device.pose_columns);
    for (const std::size_t column : device.pose_columns) {
      if (has_value(column) == is_stated) continue;
      const CsvField& field = fields_[columns_at_[column]];
      return fault(fmt::format("a pose component of {} has {}, but others have {}: all are given, "
                               "or none",
                               shown(device.name), is_stated ? "no value" : "a value",
                               is_stated ? "one" : "none"),
                   field.column);
    }
  }
  return {};
}

}  // namespace

bool hasValues(std::span<const double> row, const std::vector<std::size_t>& columns) {
  return !columns.empty() && !std::isnan(row[columns.front()]);
}

Result<CsvMotion> readCsvMotion(std::string_view text, const std::string& name,
                                const std::string& device,
                                const std::vector<std::string>& columns) {
  return Reader(text, name).read(device, columns);
}

}  // namespace rocinante
