#pragma once

#include <string>

#include "recorder/contents/log_state.h"

namespace rocinante {

/// A listing for the user: sources, then each device with its statements, then paths, drawings and
/// views. Names and strings are escaped as in packet text, so that a sender cannot move the
/// terminal's cursor.
std::string stateText(const ShownState& shown);

}  // namespace rocinante
