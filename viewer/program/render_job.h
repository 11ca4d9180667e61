#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/check/log_account.h"
#include "viewer/backdrop/backdrop_request.h"
#include "viewer/program/render_moments.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// The arguments of `rocinante-render`.
struct RenderJob : ModelSearch {
  std::filesystem::path cell;    ///< for loadCellOrLog()
  std::filesystem::path log;     ///< empty: `cell` if it is a log, else at rest
  std::filesystem::path beside;  ///< another log, drawn as ghosts; empty: none
  std::string align;             ///< of `beside`, for alignBeside(); empty: by the origins
  MomentChoice moments;          ///< `rate` is the video's if other moments are given
  BackdropRequest backdrop;
  std::vector<std::string> cameras;  ///< one picture each; none: the default
  std::filesystem::path output;      ///< one frame
  std::filesystem::path sheet;       ///< all of them on one picture
  std::filesystem::path frames;      ///< a folder of frame-00001.png ...
  std::string frame_type;            ///< their ending, without the dot; empty: png
  std::filesystem::path video;       ///< all of them, in time order
  std::filesystem::path identity;    ///< identity: a PNG or EXR with a JSON legend
  std::filesystem::path depth;       ///< depth: a PNG with its unit in JSON, or an EXR
  bool hashes = false;               ///< RenderedFrame::sha256
  FrameRequest look;                 ///< its time and camera are ignored
  std::vector<std::string> joints;   ///< for setJoints(); only without a log
  std::vector<std::string> layers;   ///< only these; empty: all
  Profile profile = Profile::reproducible;
  bool overwrite = false;
  ParallelFor parallel;            ///< for loading the cell; may be empty
  TellLoadProgress load_progress;  ///< may be empty
};

struct RenderedFrame {
  std::string time;  ///< as requested; "rest" without a log
  LogTime log_time{};
  std::string event;                      ///< the event at this time
  std::string camera;                     ///< empty: the default
  std::string sha256;                     ///< of the RGBA rows, top to bottom
  std::filesystem::path file;             ///< empty when not written
  std::filesystem::path identity, depth;  ///< the same
  StateDamage damage;                     ///< of the log; the frame may be incomplete
};

struct RenderReport {
  std::vector<RenderedFrame> frames;  ///< in the requested order, by moment, then camera
  std::vector<std::filesystem::path> videos;
  RendererKey key;
  std::string inputs;  ///< FrameMaker::inputsHash()
  std::vector<std::string> warnings;
  LogAccount account;    ///< of the log
  bool goes_on = false;  ///< NextPiece::missing() of it
  /// False when damage of the log may make a frame stale or missing, and when a mesh is missing.
  bool is_whole = true;
};

/// Draws a job's frames in time order, whatever order was requested, so that the log is read once.
/// Other threads encode and write pictures meanwhile. Each file appears complete or not at all;
/// existing files are replaced only with `overwrite` (checked before the first frame). Calls
/// `progress(done, of)` after each frame; false stops the job with an error: written frames stay,
/// sheet and video do not appear. With a damaged log, everything is drawn as far as known, and a
/// warning names the affected frames.
Result<RenderReport> render(const RenderJob& job,
                            const std::function<bool(std::size_t, std::size_t)>& progress);

}  // namespace rocinante
