#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Writes where devices were moved by hand into the cell's file, one after the other; what was
/// written, as a sentence. bad_argument when nothing was moved, or a device is of another file that
/// the cell includes and the request does not permit that.
Result<std::string> savePoses(ViewModel& model, const std::filesystem::path& cell_file,
                              const PoseRequest& wanted);

}  // namespace rocinante
