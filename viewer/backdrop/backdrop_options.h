#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "viewer/backdrop/backdrop_request.h"

namespace rocinante {

/// --backdrop, whose text is for readBackdrop(), and what goes with it.
inline CLI::Option* addBackdropOptions(CLI::App& app, std::string& text,
                                       BackdropRequest& backdrop) {
  auto* option = app.add_option("--backdrop", text,
                                "pictures of a real camera behind and over the model: a picture, "
                                "a folder with times, or a video (by ffmpeg)")
                     ->option_text("FILE[,camera=NAME][,fps=N]");
  app.add_option("--backdrop-offset", backdrop.offset,
                 "the session time at which the backdrop begins: 2.5s, -300ms; default: 0")
      ->needs(option)
      ->type_name("SECONDS");
  app.add_option("--backdrop-opacity", backdrop.opacity,
                 "how much of the backdrop covers the model: 0 (nothing) to 1")
      ->needs(option)
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
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
