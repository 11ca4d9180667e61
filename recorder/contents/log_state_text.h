#pragma once

#include <string>

#include "recorder/contents/log_state.h"

namespace rocinante {

/// For people: sources, then devices one after another with what was said about them, then paths,
/// drawings and views; names and strings as packet text writes them, so that nothing a sender said
/// can move a terminal's cursor.
std::string stateText(const ShownState& shown);

}  // namespace rocinante
