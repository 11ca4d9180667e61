#pragma once

#include <stdlib.h>

#include <string>

#include "core/cli/command_line.h"
#include "viewer/gl/offscreen_context.h"

namespace rocinante {

/// Adds --context to a program or subcommand that draws without a window. It takes effect when
/// parsed, which must be before the first thread and context.
inline void addContextOption(cli::CommandLine app) {
  app.addOption("--context", "how to draw: osmesa if available, else egl; both give the same bits")
      .oneOf({"osmesa", "egl"})
      .each([](const std::string& wanted) { ::setenv(kContextVariable, wanted.c_str(), 1); });
}

}  // namespace rocinante
