#pragma once

#include "core/cell/cell.h"

namespace rocinante {

/// A cell for a session without one: it has no device, and shows each that packets tell of as a
/// small cube where its pose is. Such a cell is never written and never judged by.
Cell bareCell();

}  // namespace rocinante
