#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

// Options that `render` and `view` have in the same words. Help lists options in the order in which
// they are added, so each is added by itself.

namespace rocinante {

/// --align, of the option --beside.
inline void addAlignOption(CLI::App& app, CLI::Option* beside, std::string& align) {
  app.add_option("--align", align,
                 "of --beside: origin, events, event:TEXT, or an offset, 2.5s; default: origin")
      ->needs(beside)
      ->type_name("HOW");
}

/// --joints, for setJoints().
inline void addJointsOption(CLI::App& app, std::vector<std::string>& joints) {
  app.add_option("--joints", joints,
                 "without a session: all joint values of a device in its model's order, "
                 "\"0 -0.785 0\"; repeatable")
      ->option_text("[DEVICE=]VALUES")
      ->allow_extra_args(false);
}

}  // namespace rocinante
