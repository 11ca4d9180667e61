#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"

namespace rocinante::bench {

/// Hills of 31,682 triangles under one picture of 1024x1024 (4 MB): hills.obj, hills.mtl,
/// hills.png in `folder`. Answers the .obj.
Result<std::filesystem::path> writeHills(const std::filesystem::path& folder);

/// `links` links in one device, each a pyramid of four triangles on a slide of its own, on a square
/// field.
Cell fieldOfLinks(std::size_t links);
/// A moment at which all of them stand elsewhere than at another `moment`.
SessionState fieldMoment(std::size_t links, int moment);
/// The same triangles as one mesh of one link, as they stand in that state.
Cell mergedField(const Cell& field, const SessionState& state);

}  // namespace rocinante::bench
