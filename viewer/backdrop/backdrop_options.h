#pragma once

#include <string>
#include <utility>

#include "core/cli/command_line.h"
#include "viewer/backdrop/backdrop_request.h"

namespace rocinante {

/// --backdrop, whose text is for readBackdrop(), and what goes with it.
inline cli::Option addBackdropOptions(cli::CommandLine app, std::string& text,
                                      BackdropRequest& backdrop) {
  const cli::Option option =
      app.addOption("--backdrop", text,
                    "pictures of a real camera behind and over the model: a picture, "
                    "a folder with times, or a video (by ffmpeg)")
          .valueText("FILE[,camera=NAME][,fps=N]");
  app.addOption("--backdrop-offset", backdrop.offset,
                "the session time at which the backdrop begins: 2.5s, -300ms; default: 0")
      .needs(option)
      .valueName("SECONDS");
  app.addOption("--backdrop-opacity", backdrop.opacity,
                "how much of the backdrop covers the model: 0 (nothing) to 1")
      .needs(option)
      .within(0.0, 1.0)
      .showDefault();
  return option;
}

/// What the text of --backdrop says; offset and opacity stay. bad_argument as parseBackdrop().
inline Status readBackdrop(const std::string& text, BackdropRequest& backdrop) {
  auto wanted = parseBackdrop(text);
  if (!wanted) return wanted.error();
  wanted->offset = backdrop.offset;
  wanted->opacity = backdrop.opacity;
  backdrop = std::move(*wanted);
  return {};
}

}  // namespace rocinante
