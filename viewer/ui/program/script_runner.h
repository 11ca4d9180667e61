#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/picture.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/user_input.h"
#include "viewer/ui/program/view_script.h"

namespace rocinante {

/// The targets of a script's commands in one frame.
struct ScriptStage {
  ViewModel& model;
  SteadyTime now;
  int width, height;
  std::function<std::vector<Vec3>()> fitted_corners;
  std::function<Status(const PictureClick&)> click;
  std::function<void(const ViewerRequests&)> grant;
  std::function<Status(const std::filesystem::path&)> make_evidence;
};

/// Runs a script frame by frame: commands run until one needs a drawn frame (`frame`, `wait`,
/// `screenshot`).
class ScriptRunner {
 public:
  ScriptRunner(std::vector<ViewCommand> commands, std::string name)
      : commands_(std::move(commands)), name_(std::move(name)) {}

  bool finished() const { return finished_; }
  /// bad_argument with NAME:LINE when a command's words are invalid.
  Status beforeFrame(const ScriptStage& stage);
  /// Writes a requested screenshot.
  Status afterFrame(const std::function<Picture()>& read);

 private:
  Status apply(const ViewCommand& command, const ScriptStage& stage);
  Status applyLook(const ViewCommand& command, const ScriptStage& stage);
  Status applyPerson(const ViewCommand& command, const ScriptStage& stage);
  Status applyPlayback(const ViewCommand& command, const ScriptStage& stage);
  Error faultAt(const ViewCommand& command, std::string what) const;
  Result<double> number(const ViewCommand& command, std::size_t word) const;

  std::vector<ViewCommand> commands_;
  std::string name_;
  std::size_t next_ = 0;
  int frames_to_wait_ = 0;
  std::optional<std::filesystem::path> screenshot_;
  bool finished_ = false;
};

}  // namespace rocinante
