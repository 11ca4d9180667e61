#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
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

/// Pictures that only the page contains: small pictures of fine frames, attribution masks, and the
/// compared frame where masks hide pixels; and the areas of masks of frames that may be approved.
/// `golden report` merges pages with it, `golden approve --artifact` approves: {"format": 1,
/// "frames": {NAME: {"small": PNG, "blame": PNG, "compared": PNG, "areas": PNG}}}, in base64.
inline constexpr char kPagePicturesFile[] = "page-pictures.json";
std::string pagePicturesJson(const SuiteReport& report);
/// Assigns them to the frames by name. Invalid entries are skipped, since no verdict depends on
/// them.
void addPagePictures(std::string_view json, SuiteReport& report);

/// `picture` reduced to the size of the page's list.
Picture listPicture(const Picture& picture);

}  // namespace rocinante
