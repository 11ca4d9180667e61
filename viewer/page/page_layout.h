#pragma once

#include <string>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "viewer/view/view_layout.h"

namespace rocinante {

/// What a page begins with of a layout of the window.
struct PageLayout {
  /// JSON for the page: camera, insets, plots, plots_height (pixels) and plots_hidden, as the
  /// layout says them; what it does not say is not there.
  std::string json;
  /// Kinds: panel, plot, camera, inset. Of plots a page has curves of values, of which the log
  /// states numbers; cameras are those of the cell, `fit`, `map`, and `fit:DEVICE` of its devices.
  Account left_out;
};

/// Reads the log to its end, when the layout has plots.
Result<PageLayout> pageLayout(const ViewLayout& layout, const Cell& cell, LogReader log);

}  // namespace rocinante
