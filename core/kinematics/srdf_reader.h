#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/report/finding.h"

namespace rocinante {

/// Most pairs of links of an SRDF file; more is refused. Its bytes and elements are bounded as
/// those of URDF.
inline constexpr std::size_t kMaxSrdfPairs = 20'000;

/// Names of two links that are not judged against each other.
using DisabledCollision = std::pair<std::string, std::string>;

/// The `<disable_collisions link1 link2>` of an SRDF file, in its order; everything else in it is
/// skipped. `path` names the bytes in faults. Empty, with a fault, when they are no SRDF.
std::vector<DisabledCollision> readSrdf(ByteView bytes, const std::filesystem::path& path,
                                        Findings& faults);

}  // namespace rocinante
