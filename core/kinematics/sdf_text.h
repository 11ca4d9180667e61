#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"

namespace rocinante {

/// The text with its `<include>`s blanked out, since libsdformat would open the files that they
/// name; places stay. Empty with a fault when it is nested too deep, or more than libsdformat makes
/// in half a minute.
std::optional<std::string> sdfWithoutIncludes(std::string text, FaultList& faults);

/// The `<uri>`s of meshes.
std::vector<std::string> sdfMeshes(std::string_view text);

}  // namespace rocinante
