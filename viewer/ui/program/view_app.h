#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/program/input_record.h"
#include "viewer/ui/program/left_sessions.h"
#include "viewer/ui/program/script_runner.h"
#include "viewer/ui/program/view_content.h"
#include "viewer/ui/program/view_script.h"
#include "viewer/ui/window/imgui_painter.h"
#include "viewer/ui/window/window.h"
#include "viewer/view/view_layout.h"

namespace rocinante {

struct ViewOptions {
  /// Of the window; 0: as remembered, else 1280x720.
  int width = 0;
  int height = 0;
  /// Neither uses nor changes what was remembered of the user.
  bool fresh = false;
  int samples = 4;
  /// Scale of text, panels and everything sized in pixels: 1 to 4; empty: the screen's, and 1 under
  /// a script.
  std::optional<double> scale;
  Profile profile = Profile::fast;
  /// A fixed rung of kDetailRungs; empty: in the fast profile the one that holds `target_fps`, else
  /// everything.
  std::optional<int> detail;
  double target_fps = 30;
  /// Drives the window instead of a user: time then advances by 1/60 s per frame, independent of
  /// the clock, and the real mouse and keyboard are ignored, so that screenshots are reproducible.
  std::vector<ViewCommand> script;
  std::string script_name;  ///< for error messages
  /// What the user does is written here, as a script; empty: it is not. Implies `fresh`.
  std::filesystem::path record_input;
  std::filesystem::path frame_times;  ///< a FrameJournal that was begun; empty: none
  std::optional<ViewLayout> layout;   ///< of what is shown first
  std::string notice;                 ///< shown for a while at the start, to a user; may be empty
};

/// What stays while one content of a window gives way to the next.
struct WindowSession {
  ContentLoader& loader;
  ScriptRunner script;
  InputRecord record;
  /// Made for the first content; its shader serves all. Needs the window's context.
  std::optional<ImguiPainter> painter;
  bool samples_reported = false;  ///< that the driver has fewer than usual
  LeftSessions left{};
};

/// Shows the content until the window is closed, the script ends, or a signal stops it: null; or
/// until the loader has something else to show. The window says what cannot be loaded, unless
/// nothing was shown yet: then it is the error. Main thread.
Result<std::unique_ptr<ViewContent>> showContent(ViewContent& content, Window& window,
                                                 const ViewOptions& options,
                                                 WindowSession& session);

}  // namespace rocinante
