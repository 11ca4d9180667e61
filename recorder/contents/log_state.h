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

}  // namespace rocinante
