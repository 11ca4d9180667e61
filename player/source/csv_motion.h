#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// A recorded motion as a table: a header row that names the columns, then one row a moment
/// (docs/programs/source.md). Seconds in column `t` or `time`; every other column is a joint.
struct CsvMotion {
  struct Row {
    Nanoseconds time{};     ///< as the file says it, rounded to the nanosecond
    std::size_t begin = 0;  ///< of its values in `values`
    std::size_t byte_count = 0;
  };

  std::vector<std::string> joints;
  std::vector<Row> rows;  ///< at least one; times never go back
  std::string values;     ///< the numbers as the file wrote them, a space between two of a row

  std::string_view valuesOf(const Row& row) const {
    return std::string_view(values).substr(row.begin, row.byte_count);
  }
};

/// Reads the whole text before anything is sent. bad_argument with line and column (bytes from 1)
/// for a ragged row, a value that packet text cannot say, a time that goes back, no time column, no
/// row. `columns`, when not empty, says which columns are joints, in this order. `name` is the
/// file's, for messages.
Result<CsvMotion> readCsvMotion(std::string_view text, const std::string& name,
                                const std::vector<std::string>& columns);

}  // namespace rocinante
