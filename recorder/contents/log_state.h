#pragma once

#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The state of a session at a moment, for display.
struct ShownState {
  std::string log;
  LogTime origin{};
  LogTime moment{};
  const SessionState* state = nullptr;  ///< borrowed
};

/// One object (docs/programs/log.md, "state"), with LF. Numbers are exact.
std::string stateJson(const ShownState& shown);

/// SHA-256 of the identity's text: equal if and only if two states are the same.
std::string identityHash(const SessionState& state);

/// A listing for the user: sources, then each device with its statements, then paths, drawings and
/// views. Names and strings are escaped as in packet text, so that a sender cannot move the
/// terminal's cursor.
std::string stateText(const ShownState& shown);

}  // namespace rocinante
