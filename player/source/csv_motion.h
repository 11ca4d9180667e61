#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// A recorded motion as a table: a header row with column names, then one row per moment
/// (docs/programs/source.md). Seconds in column `t` or `time`; every other column is a joint.
struct CsvMotion {
  struct Row {
    Nanoseconds time{};     ///< of the file, rounded to the nanosecond
    std::size_t begin = 0;  ///< offset of its values in `values`
    std::size_t byte_count = 0;
  };

  std::vector<std::string> joints;
  std::vector<Row> rows;  ///< at least one; times never go back
  std::string values;  ///< the numbers as written in the file; those of a row separated by spaces

  std::string_view valuesOf(const Row& row) const {
    return std::string_view(values).substr(row.begin, row.byte_count);
  }
};

/// Parses the whole text. bad_argument with line and column (bytes from 1) for a ragged row, a
/// value that packet text does not allow, a time that goes back, a missing time column, or no row.
/// `columns`, if not empty, names the joint columns in this order. `name` is the file's, for
/// messages.
Result<CsvMotion> readCsvMotion(std::string_view text, const std::string& name,
                                const std::vector<std::string>& columns);

}  // namespace rocinante
