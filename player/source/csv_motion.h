#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/report/account.h"
#include "player/source/csv_signals.h"

namespace rocinante {

/// A recorded motion as a table: a header with column names, then one row per moment
/// (docs/programs/source.md; the dialects of docs/other-formats.md). One column is the time; every
/// other one is a joint, a component of a pose or a signal.
struct CsvMotion {
  /// One device and the columns that move it, as indices into a row.
  struct Device {
    std::string name;
    std::vector<std::string> joints;
    std::vector<std::size_t> joint_columns;  ///< as many
    /// x y z qx qy qz qw; empty when the table has no pose of the device.
    std::vector<std::size_t> pose_columns;
  };

  std::vector<Device> devices;  ///< in the order of their first columns
  CsvSignals signals;
  std::vector<Nanoseconds> times;  ///< of the file, rounded to the nanosecond; never going back
  std::size_t column_count = 0;    ///< numbers of a row
  std::vector<double> numbers;     ///< row after row; NaN: nothing is said
  Account left_out;                ///< columns and values that are not sent

  std::size_t rowCount() const { return times.size(); }
  std::span<const double> row(std::size_t index) const {
    return std::span(numbers).subspan(index * column_count, column_count);
  }
};

/// True when the row says something in these columns of a device: its joints are given all or none,
/// and so is its pose.
bool hasValues(std::span<const double> row, const std::vector<std::size_t>& columns);

/// Parses the whole text. bad_argument with line and column (bytes from 1) for a ragged row, a
/// value that a Source cannot send, a time that goes back, a missing time column, or no row. A
/// joint without a value in a row keeps its last one; a pose has all seven components or none.
/// `columns`, if not empty, names the columns in this order; else columns that hold no values are
/// left out and named. With `device` all of them are about that device: joints, or the pose that
/// TUM writes; without it they are named DEVICE.JOINT (the first point separates) or DEVICE:x,
/// DEVICE:y, DEVICE:z, DEVICE:qx, DEVICE:qy, DEVICE:qz, DEVICE:qw. `signal PATH NAME` is a signal,
/// and so is a column whose first value is `true`, `false` or another text: NAME of DEVICE, else
/// of `device` or of none. `name` is the file's, for messages.
Result<CsvMotion> readCsvMotion(std::string_view text, const std::string& name,
                                const std::string& device, const std::vector<std::string>& columns);

}  // namespace rocinante
