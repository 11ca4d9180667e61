#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/command_line.h"

// Options that `render`, `view` and `golden add` have in the same words. Help lists options in the
// order in which they are added, so each is added by itself.

namespace rocinante {

/// --beside and its --align. `more`: what is shown of the log besides ghosts; may be empty.
inline void addBesideOptions(cli::CommandLine app, std::filesystem::path& beside,
                             std::string& align, const std::string& more = {}) {
  const cli::Option log =
      app.addOption("--beside", beside,
                    "another log of the same cell: its devices as ghosts, where they stand at "
                    "another place" +
                        more)
          .valueName("LOG");
  app.addOption("--align", align,
                "of --beside: origin, events, event:TEXT, or an offset, 2.5s; default: origin")
      .needs(log)
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

/// --hide and --show.
inline void addVisibilityOptions(cli::CommandLine app, std::vector<std::string>& hide,
                                 std::vector<std::string>& show) {
  app.addOption("--hide", hide, "do not draw PATH: DEVICE, DEVICE/LINK, layer/NAME; repeatable")
      .oneEach();
  app.addOption("--show", show, "draw PATH even if packets hide it; repeatable").oneEach();
}

/// --layers.
inline void addLayersOption(cli::CommandLine app, std::vector<std::string>& layers) {
  app.addOption("--layers", layers, "draw only these layers, separated by commas")
      .valueText("NAME,...")
      .separatedBy(',')
      .oneEach();
}

/// --profile: "reproducible" or "fast".
inline void addProfileOption(cli::CommandLine app, std::string& profile) {
  app.addOption("--profile", profile,
                "reproducible: the same bits everywhere; fast: the driver as it is")
      .oneOf({"reproducible", "fast"})
      .showDefault();
}

}  // namespace rocinante
