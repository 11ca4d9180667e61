#pragma once

#include <cstdint>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// How much of something is drawn. nothing: it has nothing to draw.
enum class ShownPart : std::uint8_t { nothing, hidden, some, all };
/// "partly shown" and so on.
const char* nameOf(ShownPart part);

/// Of each layer of the cell, in its order: what the picture shows of all that the layer holds,
/// whether packets, the cell or the user decided it.
std::vector<ShownPart> shownLayers(const Cell& cell, const PosedScene& scene,
                                   const ViewChoice& choice);

/// The same of a device, and of one of its links.
ShownPart shownDevice(const PosedDevice& device, const ViewChoice& choice);
ShownPart shownLink(const PosedDevice& device, std::size_t link, const ViewChoice& choice);

}  // namespace rocinante
