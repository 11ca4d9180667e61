#pragma once

#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// What a window says that shows nothing yet: how to open something, and what was shown before.
/// `loading`: something comes, and only that is said.
void drawWelcome(ViewModel& model, bool loading, ViewerRequests& requests);

/// What is being read, and how far; in the middle of an empty window, else above the picture.
void drawLoading(const LoadingStatus& loading, bool is_empty);

}  // namespace rocinante
