#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/view_script.h"

namespace rocinante {

struct ViewOptions {
  int width = 1280;
  int height = 720;
  int samples = 4;
  /// Scale of text, panels and everything sized in pixels: 1 to 4; empty: the screen's, and 1 under
  /// a script.
  std::optional<double> scale;
  Profile profile = Profile::fast;
  /// A fixed rung of kDetailRungs; empty: in the fast profile the one that holds `target_fps`, else
  /// everything.
  std::optional<int> detail;
  double target_fps = 30;
  /// Arguments of the program, for evidence pictures.
  std::filesystem::path cell, log;
  ModelSearch where;
  /// Drives the window instead of a user: time then advances by 1/60 s per frame, independent of
  /// the clock, and mouse and keyboard are ignored, so that screenshots are reproducible.
  std::vector<ViewCommand> script;
  std::string script_name;  ///< for error messages
};

/// Opens the window and runs until it is closed, the script ends, or a signal stops it.
/// refused when there is no display. Main thread.
Status runViewer(ViewModel& model, const ViewOptions& options);

}  // namespace rocinante
