#pragma once

#include <span>

#include "viewer/ui/model/line_start.h"

namespace rocinante {

/// Draws a line to type in, as wide as there is room. `takes_keyboard`: in a moment; what is typed
/// until then is in `start`, and is taken by the line. True when Enter was pressed.
bool drawTypedLine(const char* id, const char* hint, std::span<char> text, bool takes_keyboard,
                   LineStart& start);

}  // namespace rocinante
