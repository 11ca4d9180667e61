#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "viewer/page/page_file.h"

namespace rocinante {

/// Reads what scripts/build_web made from `folder`, or, when it is empty, from where it is
/// installed. not_found, with what to do, when it is not there.
Status readPageViewer(const std::filesystem::path& folder, PageParts& parts);

}  // namespace rocinante
