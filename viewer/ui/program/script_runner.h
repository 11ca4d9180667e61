#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
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
/// `screenshot`, `await`).
class ScriptRunner {
 public:
  /// From one frame to the next where the script says no other time.
  static constexpr Nanoseconds kFrame{1'000'000'000 / 60};

  ScriptRunner(std::vector<ViewCommand> commands, std::string name);

  /// Whether commands have changed the scene since the last call.
  bool takeChanged() { return std::exchange(changed_, false); }
  bool finished() const { return finished_; }
  /// Whether it says when frames are drawn, as the input of a person that was recorded.
  bool isTimed() const { return timed_; }
  /// The time of the coming frame.
  SteadyTime now() const { return now_; }
  /// What it sees of mouse and keyboard.
  const FrameInput& input() const { return input_; }
  /// The script continues when opened files are shown; true once. No frame is drawn before.
  bool awaitsFiles() const { return awaits_files_; }
  bool takeAwaitsFiles() { return std::exchange(awaits_files_, false); }
  /// bad_argument with NAME:LINE when a command's words are invalid.
  Status beforeFrame(const ScriptStage& stage);
  /// Writes a requested screenshot. The next frame is later.
  Status afterFrame(const std::function<Picture()>& read);

 private:
  /// What the command leaves to its caller: frames to draw, a screenshot, the end.
  Result<ViewerRequests> run(const ViewCommand& command, const ScriptStage& stage);
  Result<bool> awaited(const ViewCommand& command, const ViewerRequests& asked,
                       const ViewModel& model);
  SteadyTime timeOfNext(SteadyTime otherwise) const;
  Error faultAt(const ViewCommand& command, std::string what) const;

  std::vector<ViewCommand> commands_;
  std::string name_;
  std::size_t next_ = 0;
  int frames_to_wait_ = 0;
  std::optional<std::filesystem::path> screenshot_;
  bool finished_ = false;
  bool changed_ = false;
  bool timed_ = false;
  bool awaits_files_ = false;
  SteadyTime now_{};
  FrameInput input_;
  std::optional<SteadyTime> awaits_since_;
};

}  // namespace rocinante
