#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "golden/report/report.h"

namespace rocinante {

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
