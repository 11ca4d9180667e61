#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/picture.h"
#include "viewer/ui/commands/command.h"
#include "viewer/ui/program/view_script.h"

namespace rocinante {

/// The targets of a script's commands in one frame.
struct ScriptStage {
  ViewModel& model;
  SteadyTime now;
  int height_px;  ///< of the picture
  /// Does what a command asks of the program.
  std::function<Status(const ViewerRequests&)> apply;
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
  /// What the command leaves to its caller: frames to draw, a screenshot, the end.
  Result<ViewerRequests> run(const ViewCommand& command, const ScriptStage& stage) const;
  Result<bool> awaited(const ViewCommand& command, Nanoseconds length, const ScriptStage& stage);
  Error faultAt(const ViewCommand& command, std::string what) const;

  std::vector<ViewCommand> commands_;
  std::string name_;
  std::size_t next_ = 0;
  int frames_to_wait_ = 0;
  std::optional<std::filesystem::path> screenshot_;
  bool finished_ = false;
  std::optional<SteadyTime> awaits_since_;
};

}  // namespace rocinante
