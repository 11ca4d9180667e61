#pragma once

#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "core/time.h"

namespace rocinante {

/// The state of a session at a moment, to be shown.
struct ShownState {
  std::string log;
  LogTime origin{};
  LogTime moment{};
  const SessionState* state = nullptr;  ///< borrowed
};

/// For people: sources, then devices one after another with what was said about them, then paths,
/// drawings and views; names and strings as packet text writes them, so that nothing a sender said
/// can move a terminal's cursor.
std::string stateText(const ShownState& shown);

/// One object (docs/programs/log.md, "state"), with its line end. Numbers are exact.
std::string stateJson(const ShownState& shown);

/// SHA-256 of the identity's text: equal exactly where two states are the same.
std::string identityHash(const SessionState& state);

}  // namespace rocinante
