#pragma once

#include "core/base/bytes.h"
#include "core/base/parallel_for.h"
#include "core/cell/cell.h"

namespace rocinante {

/// The baked cell of a page: what is drawn, with pictures compressed. Of paths only the names that
/// tell pictures apart are kept, so that nobody's folders are given away and the same cell gives
/// the same bytes wherever it lies. Findings, rules and decoders are left out.
Bytes pageCell(const Cell& cell, const ParallelFor& parallel);

}  // namespace rocinante
