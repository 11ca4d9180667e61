#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "golden/approval/manifest.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// Reads one accepted picture of a manifest.
using ReadAccepted = std::function<Result<Picture>(const AcceptedPicture&)>;

/// The changes between two manifests as frames of a report, by case and key: `then` is the golden's
/// side, `now` the frame's. Unchanged ones are `same`, without pictures; replaced ones, and those
/// that judge fewer devices, `different`;
/// added and removed ones `missing`; those whose pictures cannot be read `incomparable`. `since`
/// names the older side in messages.
std::vector<JudgedFrame> manifestChanges(const Manifest& then, const ReadAccepted& read_then,
                                         const Manifest& now, const ReadAccepted& read_now,
                                         const std::string& since);

/// A name safe in file names: reports write files named after the untrusted text of a manifest.
std::string safeName(const std::string& name);

}  // namespace rocinante
