#pragma once

#include "core/cell/cell.h"
#include "core/series/stated_values.h"

namespace rocinante {

/// The names of the values of a positional `joints`, in order, by the cell's models: for devices of
/// the cell, added ones and ghosts. Borrows the cell.
PositionalNames positionalNames(const Cell& cell);

}  // namespace rocinante
