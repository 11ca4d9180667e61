#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/program/render_moments.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// What `rocinante-render` was asked for, as its arguments say it.
struct RenderJob : ModelSearch {
  std::filesystem::path cell;  ///< as loadCellOrLog() takes it
  std::filesystem::path log;   ///< empty: that of `cell` when it is one, else the cell at rest
  MomentChoice moments;        ///< its `rate` is that of the video when other moments are given
  std::vector<std::string> cameras;  ///< each a picture of its own; none: the default
  std::filesystem::path output;      ///< one frame
  std::filesystem::path sheet;       ///< all of them on one picture
  std::filesystem::path frames;      ///< a folder: frame-00001.png and on
  std::filesystem::path video;       ///< all of them, in order of time
  std::filesystem::path identity;    ///< whose pixels they are: a PNG with a JSON legend
  std::filesystem::path depth;       ///< how far they are: a PNG with its unit in JSON
  bool hashes = false;               ///< RenderedFrame::sha256
  FrameRequest look;                 ///< its time and camera are not used
  std::vector<std::string> layers;   ///< only these; empty: all
  std::vector<std::string> insets;   ///< as parseInset() takes them, in place of the cell's
  bool show_insets = true;
  Profile profile = Profile::reproducible;
  bool overwrite = false;
  ParallelFor parallel;            ///< for loading the cell; may be empty
  TellLoadProgress load_progress;  ///< may be empty
};

struct RenderedFrame {
  std::string time;  ///< as it was asked for; "rest" without a log
  LogTime log_time{};
  std::string event;                      ///< whose time it is
  std::string camera;                     ///< empty: the default
  std::string sha256;                     ///< of the RGBA rows, top to bottom
  std::filesystem::path file;             ///< empty when none was written
  std::filesystem::path identity, depth;  ///< the same
  StateDamage damage;                     ///< of the log: what it may lack
};

struct RenderReport {
  std::vector<RenderedFrame> frames;  ///< in the order asked for, of each the cameras
  std::vector<std::filesystem::path> videos;
  RendererKey key;
  std::string inputs;  ///< FrameMaker::inputsHash()
  std::vector<std::string> warnings;
  /// False when damage of the log may be why a frame is older than its time says, or not there, and
  /// when a mesh is missing.
  bool is_whole = true;
};

/// Draws what the job says, in order of time whatever the order asked for, so that the log is read
/// once. Pictures are encoded and written on another thread meanwhile. Whole files: each appears
/// complete or not at all, and an existing one is replaced only with `overwrite` (all are looked at
/// before the first is drawn). `progress(done, of)` after each frame; false stops the job, which is
/// then an error: frames that were written stay, sheet and video do not appear. Of a damaged log
/// everything is drawn as far as it can be known, and a warning says which frames that concerns.
Result<RenderReport> render(const RenderJob& job,
                            const std::function<bool(std::size_t, std::size_t)>& progress);

/// "640x480", each from 1 to 16384.
Result<std::pair<int, int>> parseSize(const std::string& text);

}  // namespace rocinante
