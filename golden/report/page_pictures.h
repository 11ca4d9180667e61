#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "golden/report/report.h"

namespace rocinante {

/// What the page shows that lies in no picture beside it: the small pictures of frames that are
/// fine, whose the differing pixels are, and the frame as it was compared where masks hide some of
/// it. `golden report` puts pages together with it:
/// {"format": 1, "frames": {NAME: {"small": PNG, "blame": PNG, "compared": PNG}}}, PNG in base64.
inline constexpr char kPagePicturesFile[] = "page-pictures.json";
std::string pagePicturesJson(const SuiteReport& report);
/// Gives them back to the frames of their names. What is none of it is left out: it judges nothing.
void addPagePictures(std::string_view json, SuiteReport& report);

/// `picture` as small as the page's list shows it.
Picture listPicture(const Picture& picture);
std::string base64Text(ByteView bytes);

}  // namespace rocinante
