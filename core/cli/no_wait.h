#pragma once

#include "core/cli/command_line.h"

namespace rocinante::cli {

/// `--no-wait`, the same in every program that opens endpoints: without it a NATS server that is
/// not there yet is waited for, so that programs may be started in any order.
inline void addNoWait(CommandLine app, bool& no_wait) {
  app.addFlag("--no-wait", no_wait, "end at once when a NATS server is not there yet");
}

/// For Endpoints, after parsing.
template <class Endpoints>
void applyNoWait(bool no_wait, Endpoints& endpoints) {
  for (auto& each : endpoints) each.nats.waits = !no_wait;
}

}  // namespace rocinante::cli
