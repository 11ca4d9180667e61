#pragma once

#include <optional>
#include <string>
#include <vector>

#include "golden/report/report.h"

namespace rocinante {

/// One picture of all differences of a run, for a page that shows one.
struct DifferenceSheet {
  /// Three small pictures a row: frame, golden, difference. Grey where there is none.
  Picture picture;
  std::vector<std::string> rows;  ///< the frame of each row, from the top
  std::size_t left_out = 0;       ///< frames for which there was no room
};

/// Its name in a report's folder.
inline constexpr char kDifferenceSheetFile[] = "differences.png";

/// Of the frames that are not fine and were drawn, in the report's order, at most 40. Empty when
/// there are none.
std::optional<DifferenceSheet> differenceSheet(const SuiteReport& report);

}  // namespace rocinante
