#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// What `rocinante-render` was asked for, as its arguments say it.
struct RenderJob {
  std::filesystem::path cell;    ///< as loadCellOrLog() takes it
  std::filesystem::path log;     ///< empty: that of `cell` when it is one, else the cell at rest
  std::vector<std::string> at;   ///< session times
  std::string every;             ///< a duration: from the log's start to its end
  std::filesystem::path output;  ///< one frame
  std::filesystem::path sheet;   ///< all of them on one picture
  std::filesystem::path frames;  ///< a folder: frame-00001.png and on
  FrameRequest look;             ///< its time is not used
  Profile profile = Profile::reproducible;
  std::vector<std::filesystem::path> search;
  bool search_environment = false;  ///< ROCINANTE_PATH, AMENT_PREFIX_PATH, ROS_PACKAGE_PATH too
  bool overwrite = false;
};

struct RenderedFrame {
  std::string time;  ///< as it was asked for; "rest" without a log
  LogTime log_time{};
  std::string sha256;          ///< of the RGBA rows, top to bottom
  std::filesystem::path file;  ///< empty when none was written
};

struct RenderReport {
  std::vector<RenderedFrame> frames;
  RendererKey key;
  std::string inputs;  ///< FrameMaker::inputsHash()
  std::vector<std::string> warnings;
};

/// Draws what the job says. Whole files: each appears complete or not at all, and an existing one
/// is replaced only with `overwrite` (all are looked at before the first is drawn). `progress(done,
/// of)` after each frame; false stops the job, which is then an error.
Result<RenderReport> render(const RenderJob& job,
                            const std::function<bool(std::size_t, std::size_t)>& progress);

/// "640x480", each from 1 to 16384.
Result<std::pair<int, int>> parseSize(const std::string& text);

}  // namespace rocinante
