#pragma once

#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// The list of files to open: type a part of a name or a path, choose with arrow keys and Enter, or
/// click; what was shown before comes first.
void drawOpenList(ViewModel& model, ViewerRequests& requests);

/// A line for something that was shown before; true when it is clicked.
bool drawRecent(const RecentContent& recent, bool chosen);
void openRecent(const RecentContent& recent, ViewerRequests& requests);

}  // namespace rocinante
