#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// A mouse click on the picture, in pixels from its top left.
struct PictureClick {
  double x = 0, y = 0;
  bool twice = false;  ///< turn about the point there
};

/// Another log beside the session that is shown.
struct BesideWish {
  std::filesystem::path file;  ///< empty: there shall be none
  std::string align;           ///< for alignBeside(); empty: by their origins
};

/// Write where devices were moved by hand into the cell.
struct PoseRequest {
  std::string device;     ///< empty: all that were moved
  bool included = false;  ///< also into a file that the cell includes
};

/// What panels and commands ask of the program in this frame: everything that needs the window, the
/// renderer or another process.
struct ViewerRequests {
  bool fit = false;
  bool fit_selected = false;
  std::optional<std::string> built_in_camera;  ///< "fit", "map" or "fit:DEVICE"
  bool reset = false;                          ///< back to the initial camera
  bool evidence = false;                       ///< into a new file of the working folder
  bool measure_scene = false;                  ///< for the speed of flying
  std::optional<std::filesystem::path> evidence_file;
  /// Of the part between A and B; empty: a new file of the working folder.
  std::optional<std::filesystem::path> video;
  /// The picture as a case of a suite: its name, which may be empty, and the suite.
  std::optional<std::pair<std::string, std::filesystem::path>> golden_case;
  std::optional<std::filesystem::path> screenshot;  ///< of the coming frame, panels included
  std::vector<std::filesystem::path> open;          ///< show these files instead
  std::optional<BesideWish> beside;
  std::vector<std::string> connect;  ///< listen at these endpoints, as they were typed; empty: no
  bool to_live = false;              ///< show the live session that goes on behind what is shown
  std::optional<bool> disconnect;    ///< end a live session; true: though it has heard something
  std::optional<std::string> save_camera;  ///< the view as a camera of the cell, by this name
  std::optional<PoseRequest> save_pose;
  bool close = false;
  bool save_live =
      false;  ///< the kept log of a live session, into a new file of the working folder
  std::optional<std::filesystem::path> save_file;  ///< the same into this file, waiting for it
  /// Wait until the growing session is this long.
  std::optional<Nanoseconds> await_length;
  /// Wait until a line over the picture says this; empty: until there is none.
  std::optional<std::string> await_line;
  std::optional<PictureClick> click;
  /// What others are pointed at: a place of the picture.
  std::optional<PictureClick> point;
  std::optional<std::string> mark;
  std::optional<double> target_fps;
  /// A fixed rung, or -1 for the governor's choice.
  std::optional<int> rung;
  /// Frames that a script draws before its next command.
  std::optional<int> frames;
  /// Draw a frame at this time since the script began.
  std::optional<Nanoseconds> frame_at;
  /// Wait until the files that were opened are shown.
  bool await_files = false;
  /// What a command found: a sentence to show.
  std::optional<std::string> notice;
  /// Why a key or a typed command did nothing: a sentence to show.
  std::optional<std::string> fault;
  /// Write how the panels of the last frame can be read.
  std::optional<std::filesystem::path> legibility;
};

}  // namespace rocinante
