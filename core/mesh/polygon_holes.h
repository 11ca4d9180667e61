#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vector.h"

namespace rocinante {

/// The corners of a polygon with holes as one loop for PolygonCutter: bridges lead to each hole and
/// back. `corners` are those of the outline, then of each hole, either way round; `ends` is where
/// the outline and each hole end. Cubic in their number at worst.
std::vector<std::uint32_t> loopAroundHoles(std::span<const glm::vec3> corners,
                                           std::span<const std::size_t> ends);

}  // namespace rocinante
