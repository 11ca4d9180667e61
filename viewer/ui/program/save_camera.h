#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Appends the present view to the cell's file and to the model's cameras. Fails as appendCamera()
/// does.
Status saveCamera(ViewModel& model, const std::filesystem::path& cell_file,
                  const std::string& name);

}  // namespace rocinante
