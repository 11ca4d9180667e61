#pragma once

#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <string>

#include "viewer/gl/offscreen_context.h"

namespace rocinante {

/// Adds --context to a program or subcommand that draws without a window. It takes effect when
/// parsed, which must be before the first thread and context.
inline void addContextOption(CLI::App& app) {
  app.add_option("--context", "how to draw: osmesa if available, else egl; both give the same bits")
      ->check(CLI::IsMember({"osmesa", "egl"}))
      ->each([](const std::string& wanted) { ::setenv(kContextVariable, wanted.c_str(), 1); });
}

}  // namespace rocinante
