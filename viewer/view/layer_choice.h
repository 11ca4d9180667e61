#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante {

/// Every layer of a picture of the cell: the cell's layers and the built-in ones (grid, gnomon,
/// labels, lines, points).
using KnownLayers = std::set<std::string, std::less<>>;
KnownLayers knownLayers(const Cell& cell);

/// Only these layers: hides every device and the built-in layers, and shows these.
void chooseLayers(const std::vector<std::string>& layers, std::vector<std::string>& hide,
                  std::vector<std::string>& show);

}  // namespace rocinante
