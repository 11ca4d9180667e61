#pragma once

#include <string>

#include "recorder/contents/log_state.h"

namespace rocinante {

/// One object (docs/programs/log.md, "state"), with LF. Numbers are exact.
std::string stateJson(const ShownState& shown);

/// SHA-256 of the identity's text: equal if and only if two states are the same.
std::string identityHash(const SessionState& state);

}  // namespace rocinante
