#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "golden/report/report.h"

namespace rocinante {

/// One picture of all differences of a run, for a page that shows one: what is in it.
struct DifferenceSheet {
  std::vector<const JudgedFrame*> rows;  ///< from the top; of the report, which must outlive it
  std::size_t left_out = 0;              ///< frames for which there is no room
};

/// Its name in a report's folder.
inline constexpr char kDifferenceSheetFile[] = "differences.png";

/// Of the frames that are not fine and were drawn, in the report's order, at most 40. Empty when
/// there are none.
std::optional<DifferenceSheet> differenceSheet(const SuiteReport& report);

/// Three small pictures a row: frame, golden, difference. Grey where there is none.
Picture sheetPicture(const DifferenceSheet& sheet);

}  // namespace rocinante
