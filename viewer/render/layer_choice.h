#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/result.h"
#include "viewer/render/render_style.h"

namespace rocinante {

/// Every layer that a picture of the cell can have: the cell's own, and those that are always
/// there (grid, gnomon, labels, lines, points).
using KnownLayers = std::set<std::string, std::less<>>;
KnownLayers knownLayers(const Cell& cell);

/// Only these layers: hides every device and the built-in layers, and shows these.
void chooseLayers(const std::vector<std::string>& layers, std::vector<std::string>& hide,
                  std::vector<std::string>& show);

/// not_found for a `layer/NAME` that is none of `known`: only the cell can bring a layer, so it is
/// a slip. What is no PATH at all is left to those who use it.
Status checkLayers(const KnownLayers& known, const std::vector<std::string>& paths);
Status checkLayers(const KnownLayers& known, const RenderStyle& style);

}  // namespace rocinante
