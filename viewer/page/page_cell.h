#pragma once

#include "core/base/bytes.h"
#include "core/base/parallel_for.h"
#include "core/cell/cell.h"

namespace rocinante {

/// How much smaller a cell is made than it is.
struct Thinness {
  int halvings = 0;      ///< of the triangles, as coarseMesh() leaves them out
  int largest_side = 0;  ///< of a picture, in pixels; 0: as it is
};

/// The baked cell of a page: what is drawn, with pictures compressed. Of paths only the names that
/// tell pictures apart are kept, so that nobody's folders are given away and the same cell gives
/// the same bytes wherever it lies. Findings, rules, decoders and collision geometry are left out.
Bytes pageCell(const Cell& cell, const Thinness& thinness, const ParallelFor& parallel);

}  // namespace rocinante
