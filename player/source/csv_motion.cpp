#include "player/source/csv_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_column.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// A field for an error message, shortened.
std::string shown(std::string_view text) {
  constexpr std::size_t kMax = 40;
  if (text.empty()) return "an empty field";
  return text.size() <= kMax ? fmt::format("`{}`", text)
                             : fmt::format("`{}...`", text.substr(0, kMax));
}

/// Reads one text; keeps its position for error messages.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Result<CsvMotion> read(const std::string& device, const std::vector<std::string>& columns) {
    // A byte order mark is not part of the first column's name.
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (const Status header = readHeader(columns); !header) return header.error();
    if (const Status shared = shareOut(device); !shared) return shared.error();
    while (nextLine()) {
      if (const Status row = readRow(); !row) return row.error();
    }
    if (motion_.times.empty()) return fault("there is no row below the header", 1);
    return std::move(motion_);
  }

 private:
  /// The next line that is not blank.
  bool nextLine() {
    while (const auto line = takeLine(rest_)) {
      ++line_;
      if (line->find_first_not_of(" \t") == line->npos) continue;
      split_ = splitCsvLine(*line, fields_);
      return true;
    }
    return false;
  }

  Error fault(std::string what, std::size_t column) const {
    return {ErrorKind::bad_argument, std::move(what),
            fmt::format("{}, line {}, column {}", name_, line_, column)};
  }
  Error badQuotes() const { return fault("a quoted field is not closed", fields_.back().column); }

  Status readHeader(const std::vector<std::string>& columns);
  Status chooseColumns(const std::vector<std::string>& columns);
  Status shareOut(const std::string& device);
  Status addColumn(std::size_t index);
  Status readRow();
  Status checkEmptyFields() const;

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 0;
  std::vector<CsvField> fields_;  ///< of the current line
  bool split_ = true;

  std::vector<std::string> names_;  ///< of all columns
  bool names_devices_ = false;      ///< the columns do: there is no --device
  std::size_t time_at_ = 0;
  std::vector<std::size_t> columns_at_;
  CsvMotion motion_;
};

Status Reader::readHeader(const std::vector<std::string>& columns) {
  if (!nextLine()) return Error{ErrorKind::bad_argument, "the file has no header row", name_};
  if (!split_) return badQuotes();
  for (const CsvField& field : fields_) {
    std::string name = field.unescaped();
    if (name.empty()) return fault("a column has no name", field.column);
    if (name.size() > limits::kNameBytes) {
      return fault("a column's name is longer than 255 bytes", field.column);
    }
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) {
      return fault(fmt::format("two columns are named {}", shown(name)), field.column);
    }
    names_.push_back(std::move(name));
  }
  auto time = std::find(names_.begin(), names_.end(), "t");
  if (time == names_.end()) time = std::find(names_.begin(), names_.end(), "time");
  if (time == names_.end()) return fault("no column is named `t` or `time` (seconds)", 1);
  time_at_ = static_cast<std::size_t>(time - names_.begin());
  return chooseColumns(columns);
}

Status Reader::chooseColumns(const std::vector<std::string>& columns) {
  if (columns.empty()) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (i != time_at_ && !names_[i].starts_with(kClearanceColumn)) columns_at_.push_back(i);
    }
  }
  for (const std::string& wanted : columns) {
    const auto found = std::find(names_.begin(), names_.end(), wanted);
    if (found == names_.end()) return fault(fmt::format("no column is named {}", shown(wanted)), 1);
    const auto at = static_cast<std::size_t>(found - names_.begin());
    if (std::find(columns_at_.begin(), columns_at_.end(), at) != columns_at_.end()) {
      return fault(fmt::format("column {} is chosen twice", shown(wanted)), 1);
    }
    columns_at_.push_back(at);
  }
  if (columns_at_.empty()) return fault("the table has no joint column", 1);
  motion_.column_count = columns_at_.size();
  return {};
}

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Finds the device of a column by its name, or adds it.
CsvMotion::Device& deviceNamed(CsvMotion& motion, std::string_view name) {
  for (CsvMotion::Device& device : motion.devices) {
    if (device.name == name) return device;
  }
  return motion.devices.emplace_back(CsvMotion::Device{std::string(name), {}, {}, {}});
}

Status Reader::addColumn(std::size_t index) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const std::string_view name = names_[columns_at_[index]];
  const auto column = tableColumn(name);
  if (!column) {
    return fault(fmt::format("column {} names no device: without --device a column is DEVICE.JOINT "
                             "or DEVICE:x, :y, :z, :qx, :qy, :qz, :qw",
                             shown(name)),
                 1);
  }
  CsvMotion::Device& device = deviceNamed(motion_, column->device);
  if (column->pose_part) {
    device.pose_columns.resize(kPoseEndings.size(), kNone);
    device.pose_columns[*column->pose_part] = index;
    return {};
  }
  device.joints.emplace_back(column->joint);
  device.joint_columns.push_back(index);
  return {};
}

Status Reader::shareOut(const std::string& device) {
  names_devices_ = device.empty();
  for (std::size_t i = 0; i < columns_at_.size(); ++i) {
    if (device.empty()) {
      if (const Status added = addColumn(i); !added) return added;
      continue;
    }
    CsvMotion::Device& only = deviceNamed(motion_, device);
    only.joints.push_back(names_[columns_at_[i]]);
    only.joint_columns.push_back(i);
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

Status Reader::readRow() {
  if (!split_) return badQuotes();
  if (fields_.size() != names_.size()) {
    return fault(
        fmt::format("the row has {} fields, the header has {}", fields_.size(), names_.size()),
        fields_.back().column);
  }
  const CsvField& moment = fields_[time_at_];
  const auto time = tableSeconds(moment.text);
  if (!time) {
    return fault(fmt::format("{} is not a time in seconds", shown(moment.text)), moment.column);
  }
  if (!motion_.times.empty() && *time < motion_.times.back()) {
    return fault(fmt::format("the time goes back: {} follows a later time", shown(moment.text)),
                 moment.column);
  }
  for (const std::size_t at : columns_at_) {
    const CsvField& field = fields_[at];
    if (field.text.empty() && names_devices_) {
      motion_.numbers.push_back(kNoValue);
      continue;
    }
    double number = 0;
    const char* read = field.text.data();
    const char* end = read + field.text.size();
    if (!readNumber(read, end, number) || read != end) {
      return fault(fmt::format("{} is not a number that packet text allows, in {}",
                               shown(field.text), shown(names_[at])),
                   field.column);
    }
    if (!(std::abs(number) < 0x1p53)) {
      return fault(fmt::format("{} is not below 2^53, in {}", shown(field.text), shown(names_[at])),
                   field.column);
    }
    motion_.numbers.push_back(number);
  }
  motion_.times.push_back(*time);
  return names_devices_ ? checkEmptyFields() : Status{};
}

/// A device's joints are said together, and so is a pose.
Status Reader::checkEmptyFields() const {
  const std::span<const double> row = motion_.row(motion_.rowCount() - 1);
  for (const CsvMotion::Device& device : motion_.devices) {
    for (const std::vector<std::size_t>* columns : {&device.joint_columns, &device.pose_columns}) {
      if (columns->empty()) continue;
      const bool is_said = hasValues(row, *columns);
      for (const std::size_t column : *columns) {
        if (std::isnan(row[column]) != is_said) continue;
        const CsvField& field = fields_[columns_at_[column]];
        return fault(fmt::format("{} of {} has {}, but others have {}: all are given, or none",
                                 columns == &device.pose_columns ? "a pose component" : "a joint",
                                 shown(device.name), is_said ? "no value" : "a value",
                                 is_said ? "one" : "none"),
                     field.column);
      }
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
