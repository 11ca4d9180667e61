#pragma once

#include <string>
#include <vector>

#include "core/cli/command_line.h"

// Options that `render` and `view` have in the same words. Help lists options in the order in which
// they are added, so each is added by itself.

namespace rocinante {

/// --align, of the option --beside.
inline void addAlignOption(cli::CommandLine app, cli::Option beside, std::string& align) {
  app.addOption("--align", align,
                "of --beside: origin, events, event:TEXT, or an offset, 2.5s; default: origin")
      .needs(beside)
      .valueName("HOW");
}

/// --joints, for setJoints().
inline void addJointsOption(cli::CommandLine app, std::vector<std::string>& joints) {
  app.addOption("--joints", joints,
                "without a session: all joint values of a device in its model's order, "
                "\"0 -0.785 0\"; repeatable")
      .valueText("[DEVICE=]VALUES")
      .oneEach();
}

}  // namespace rocinante
