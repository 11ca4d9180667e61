#pragma once

#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// Asks for the text of a mark at the shown moment, while model.panels.asks_mark: Enter keeps it
/// ("mark" when nothing was typed), Esc does not.
void drawMarkPrompt(ViewModel& model, ViewerRequests& requests);

}  // namespace rocinante
