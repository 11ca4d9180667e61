#include <fmt/format.h>

#include "core/base/number_list.h"
#include "core/cell/view_path.h"
#include "core/kinematics/joint_values.h"
#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

/// The device of DEVICE or DEVICE/JOINT, and the joint, which may be empty.
struct HandTarget {
  const PosedDevice* device = nullptr;
  std::string value_name;
};

Result<HandTarget> targetOf(const ViewModel& model, const std::string& text) {
  const auto path = parseViewPath(text);
  if (!path) return path.error();
  HandTarget target{model.scene().findDevice(path->path.first), path->path.second};
  if (path->path.is_layer || target.device == nullptr || target.device->model == nullptr) {
    return badWord(fmt::format("there is no device `{}`", text));
  }
  return target;
}

Status moveJoint(CommandWords words, const CommandStage& stage) {
  const auto target = targetOf(stage.model, words[0]);
  if (!target) return target.error();
  const Model& model = *target->device->model;
  const auto driven = drivenValue(model, target->value_name);
  if (!driven) return driven.error();
  const bool turns = kindOf(model.joints[driven->joint], driven->component) == ValueKind::angle;
  const auto value =
      turns ? parseAngle(words[1], AngleUnit::radians) : parseLength(words[1], LengthUnit::metres);
  if (!value) {
    return badWord(
        fmt::format("`{}` is not {}", words[1],
                    turns ? "an angle: 0.5, 0.5rad, 30deg" : "a length: 0.12, 0.12m, 120mm"));
  }
  return stage.model.setByHand(target->device->name, target->value_name, *value, stage.now);
}

Status moveJoints(CommandWords words, const CommandStage& stage) {
  const auto target = targetOf(stage.model, words[0]);
  if (!target) return target.error();
  const auto values = parseNumbers(words[1]);
  if (!values) return values.error();
  return stage.model.setByHand(target->device->name, *values, stage.now);
}

Status giveBack(CommandWords words, const CommandStage& stage) {
  HandControl& hand = stage.model.hand;
  if (words[0] == "all") {
    hand.resetAll();
    return {};
  }
  const auto target = targetOf(stage.model, words[0]);
  if (!target) return target.error();
  if (target->value_name.empty()) {
    hand.reset(target->device->name);
    return {};
  }
  const auto driven = drivenValue(*target->device->model, target->value_name);
  if (!driven) return driven.error();
  hand.reset(target->device->name, target->value_name);
  return {};
}

Status driveDevices(CommandWords words, const CommandStage& stage) {
  if (words.empty()) {
    if (stage.model.hand.driving() == nullptr) return stage.model.hand.driveAgain();
    stage.model.hand.stopDriving();
    return {};
  }
  const std::string& word = words[0];
  if (word == "off") {
    stage.model.hand.stopDriving();
    return {};
  }
  const std::size_t comma = word.rfind(',');
  const std::string source =
      comma == std::string::npos ? DriveSettings().source : word.substr(comma + 1);
  return stage.model.hand.drive(word.substr(0, comma), source);
}

Status backHome(CommandWords /*words*/, const CommandStage& stage) {
  // First: letting go would be said to receivers.
  stage.model.hand.stopDriving();
  stage.model.hand.resetAll();
  return {};
}

Status setUnits(CommandWords words, const CommandStage& stage) {
  Units& units = stage.model.hand.units;
  if (words.empty()) {
    const Units of_packets{AngleUnit::radians, LengthUnit::metres};
    units = units == of_packets ? Units{} : of_packets;
  } else if (!setUnit(units, words[0])) {
    return badWord(fmt::format("`{}` is not a unit: deg, rad, mm or m", words[0]));
  }
  // For what follows in the same frame.
  RenderStyle style = stage.model.style();
  style.lengths = units.length;
  stage.model.setStyle(style);
  return {};
}

}  // namespace

std::vector<Command> handCommands() {
  std::vector<Command> commands{
      {.name = "joint",
       .arguments = "DEVICE/JOINT VALUE",
       .means = "move a joint by hand: 30deg, 0.5rad, 120mm",
       .run = moveJoint},
      {.name = "joints",
       .arguments = "DEVICE VALUES",
       .means = "all joints of a device, as --joints",
       .run = moveJoints},
      {.name = "reset",
       .arguments = "DEVICE[/JOINT]|all",
       .means = "joints moved by hand: give them back",
       .run = giveBack},
      {.name = "give-back",
       .means = "all joints moved by hand: give them back; ends driving",
       .run = backHome,
       .shortcuts = {{"backspace", "", ""}}},
      {.name = "units",
       .arguments = "[UNIT]",
       .means = "deg, rad, mm or m; without one, those of people or of packets",
       .run = setUnits,
       .shortcuts = {{"U", "", "degrees and mm, or radians and m"}}},
      {.name = "drive",
       .arguments = "[EP[,NAME]|off]",
       .means = "driving: send what is moved by hand to an endpoint, until Esc",
       .run = driveDevices},
  };
  for (Command& command : commands) command.group = CommandGroup::picture;
  return commands;
}

}  // namespace rocinante
