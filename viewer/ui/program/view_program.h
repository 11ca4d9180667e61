#pragma once

#include "viewer/ui/program/view_app.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// Opens the window and shows what is asked for, then what the user opens, until it is closed, the
/// script ends, or a signal stops it. The window comes first: what takes long to read appears in it
/// when it is there. True when all that was shown is beyond doubt; the doubts are printed.
/// refused when there is no display; the error of reading what was asked for at first. Main thread.
Result<bool> runViewer(const ContentRequest& first, const ViewOptions& options);

}  // namespace rocinante
