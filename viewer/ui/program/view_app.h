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
  /// Of text and panels, and of what of the picture has its size in pixels: 1 to 4; empty: as the
  /// screen asks for it, and 1 under a script.
  std::optional<double> scale;
  Profile profile = Profile::fast;
  /// A rung of kDetailRungs to stay on; empty: in the fast profile what holds `target_fps`, else
  /// everything.
  std::optional<int> detail;
  double target_fps = 30;
  /// What evidence pictures are made of: as the program was given them.
  std::filesystem::path cell, log;
  ModelSearch where;
  /// Drives the window in place of a person: time is then frames at 60 a second, whatever the clock
  /// says, and mouse and keyboard are left alone, so that a screenshot comes out the same each
  /// time.
  std::vector<ViewCommand> script;
  std::string script_name;  ///< for faults
};

/// Opens the window and runs until it is closed, the script ends, or a signal stops it.
/// refused when there is no display. Main thread.
Status runViewer(ViewModel& model, const ViewOptions& options);

}  // namespace rocinante
