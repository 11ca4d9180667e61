#include <fmt/format.h>

#include "core/math/transform.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/model/pose_fields.h"

namespace rocinante {
namespace {

/// Three lengths or angles of the words after the first.
Result<Vec3> threeOf(CommandWords words, bool angles) {
  Vec3 values;
  for (int i = 0; i < 3; ++i) {
    const std::string& word = words[static_cast<std::size_t>(i) + 1];
    const auto value =
        angles ? typedAngle(word, AngleUnit::radians) : typedLength(word, LengthUnit::metres);
    if (!value) return value.error();
    values[i] = *value;
  }
  return values;
}

Status moveDevice(CommandWords words, const CommandStage& stage) {
  const auto place = threeOf(words, false);
  if (!place) return place.error();
  const auto pose = stage.model.movablePose(words[0]);
  if (!pose) return pose.error();
  stage.model.moves.put(words[0], Pose{*place, pose->orientation});
  return {};
}

Status turnDevice(CommandWords words, const CommandStage& stage) {
  const auto rpy = threeOf(words, true);
  if (!rpy) return rpy.error();
  const auto pose = stage.model.movablePose(words[0]);
  if (!pose) return pose.error();
  stage.model.moves.put(words[0], Pose{pose->position, quaternionFromRpy(*rpy)});
  return {};
}

Status putBack(CommandWords words, const CommandStage& stage) {
  DeviceMoves& moves = stage.model.moves;
  if (words[0] != "all") {
    if (moves.find(words[0]) == nullptr) {
      return badWord(fmt::format("`{}` was not moved by hand", words[0]));
    }
    moves.put(words[0], std::nullopt);
    return {};
  }
  while (!moves.poses().empty()) {
    const std::string device = moves.poses().begin()->first;
    moves.put(device, std::nullopt);
  }
  return {};
}

Status undoMove(CommandWords /*words*/, const CommandStage& stage) {
  return stage.model.moves.undo() ? Status{} : Status{badWord("there is no move to undo")};
}

Status redoMove(CommandWords /*words*/, const CommandStage& stage) {
  return stage.model.moves.redo() ? Status{} : Status{badWord("there is no move to do again")};
}

Status saveMoved(CommandWords words, const CommandStage& stage) {
  const bool included = !words.empty() && words.back() == "included";
  if (words.size() > 1 && !included) {
    return badWord(fmt::format("`{}` is not `included`", words.back()));
  }
  const bool named = words.size() > (included ? 1U : 0U);
  stage.requests.save_pose = PoseRequest{named ? words[0] : "", included};
  return {};
}

Status showGizmo(CommandWords words, const CommandStage& stage) {
  GizmoState& gizmo = stage.model.viewer.gizmo;
  const auto on = switched(words, gizmo.shown);
  if (!on.ok()) return on.error();
  if (!*on) releaseGizmo(stage.model);
  gizmo.shown = *on;
  return {};
}

Status setSnapping(CommandWords words, const CommandStage& stage) {
  bool& snaps = stage.model.viewer.gizmo.snaps;
  const auto on = switched(words, snaps);
  if (!on.ok()) return on.error();
  snaps = *on;
  return {};
}

std::vector<std::string> movedDevices(const ViewModel& model) {
  std::vector<std::string> names;
  for (const auto& [device, pose] : model.moves.poses()) names.push_back(device);
  return names;
}

bool anyMoved(const ViewModel& model) { return !model.moves.poses().empty(); }
bool canUndo(const ViewModel& model) { return model.moves.canUndo(); }
bool canRedo(const ViewModel& model) { return model.moves.canRedo(); }

}  // namespace

std::vector<Command> moveCommands() {
  std::vector<Command> commands{
      {.name = "move",
       .arguments = "DEVICE X Y Z",
       .means = "put a device of the cell there: 0.5, 120mm",
       .run = moveDevice},
      {.name = "turn",
       .arguments = "DEVICE ROLL PITCH YAW",
       .means = "turn a device of the cell: 0.5, 30deg",
       .run = turnDevice},
      {.name = "gizmo",
       .arguments = "[on|off]",
       .means = "handles that move and turn the selected device",
       .run = showGizmo,
       .shortcuts = {{"ctrl+G", "", ""}}},
      {.name = "snap",
       .arguments = "[on|off]",
       .means = "the handles move and turn by whole steps",
       .run = setSnapping},
      {.name = "undo",
       .means = "undo the last move of a device",
       .run = undoMove,
       .shortcuts = {{"ctrl+Z", "", ""}},
       .offered = canUndo,
       .repeats = true},
      {.name = "redo",
       .means = "do the move again that was undone",
       .run = redoMove,
       .shortcuts = {{"ctrl+Y", "", ""}},
       .offered = canRedo,
       .repeats = true},
      {.name = "put-back",
       .arguments = "DEVICE|all",
       .means = "devices that were moved: back to where the cell has them",
       .run = putBack,
       .offered = anyMoved,
       .choices = movedDevices},
      {.name = "save-pose",
       .arguments = "[DEVICE] [included]",
       .means = "write where devices were moved into the cell, or into a file that it includes",
       .run = saveMoved,
       .offered = anyMoved,
       .choices = movedDevices},
  };
  for (Command& command : commands) command.group = CommandGroup::picture;
  return commands;
}

}  // namespace rocinante
