#include <fmt/format.h>

#include <algorithm>

#include "core/cell/view_path.h"
#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

Status measureDistance(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  if (!words.empty() && words[0] == "none") {
    model.viewer.picking.end();
    RenderStyle style = model.style();
    style.measures.clear();
    model.setStyle(style);
    return {};
  }
  const auto on = switched(words, model.viewer.picking.active());
  if (!on.ok()) return on.error();
  *on ? model.viewer.picking.begin() : model.viewer.picking.end();
  return {};
}

Status setReference(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  if (words[0] == "world") {
    model.viewer.reference = {};
    return {};
  }
  const auto path = parseViewPath(words[0]);
  if (!path) return path.error();
  const Selection wanted{path->path.first, path->path.second};
  if (path->path.is_layer || !model.scene().find(wanted.device, wanted.link)) {
    return badWord(fmt::format("there is no device or link `{}`", words[0]));
  }
  model.viewer.reference = wanted;
  return {};
}

Status showPacket(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  const std::string word = words.empty() ? "on" : words[0];
  model.viewer.packet.wanted = word != "off";
  model.viewer.packet.value_name = word == "on" || word == "off" ? std::string() : word;
  if (!model.viewer.packet.wanted) return {};
  const Selection shown = model.inspected();
  if (shown.device.empty()) return badWord("`packet-behind` needs a selected device");
  // To its end: a script's next picture shows what was found.
  do {
    model.viewer.packet.look(model.session()->log().name(),
                             {shown.device, model.viewer.packet.value_name}, model.shownTime(),
                             100'000);
  } while (model.viewer.packet.searching() && model.viewer.packet.trouble.empty());
  return model.viewer.packet.trouble.empty() ? Status{}
                                             : Status{badWord(model.viewer.packet.trouble)};
}

Status followSelection(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  const bool follows = !model.followed().device.empty();
  const auto on = switched(words, follows);
  if (!on.ok()) return on.error();
  if (*on && !words.empty() && model.selected.device.empty()) {
    return badWord("`follow` needs a selected device");
  }
  if (*on != follows) model.toggleFollowing();
  return {};
}

Status showNearest(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, stage.model.viewer.nearest_wanted);
  if (!on.ok()) return on.error();
  stage.model.viewer.nearest_wanted = *on;
  return {};
}

Status toggleAxes(CommandWords /*words*/, const CommandStage& stage) {
  ViewModel& model = stage.model;
  RenderStyle style = model.style();
  const std::string path = model.selected.device.empty() ? "*" : model.selected.path();
  if (std::erase(style.frames, path) == 0) style.frames.push_back(path);
  model.setStyle(style);
  return {};
}

}  // namespace

std::vector<Command> inspectCommands() {
  std::vector<Command> commands{
      {.name = "measure",
       .arguments = "[on|off|none]",
       .means = "pick two points for a distance; none: remove all distances",
       .run = measureDistance,
       .shortcuts = {{"X", "", "distance of two points"},
                     {"shift+X", "none", "without any distance"}}},
      {.name = "nearest",
       .arguments = "[on|off]",
       .means = "how near the selection is to the reference, or to the nearest other device",
       .run = showNearest,
       .shortcuts = {{"shift+N", "", ""}}},
      {.name = "axes",
       .means = "axes of the selection, else of all links",
       .run = toggleAxes,
       .shortcuts = {{"O", "", ""}}},
      {.name = "reference",
       .arguments = "PATH|world",
       .means = "poses as seen from this device or link",
       .run = setReference},
      {.name = "follow",
       .arguments = "[on|off]",
       .means = "the camera goes with the selection",
       .run = followSelection,
       .shortcuts = {{"V", "", ""}}},
      {.name = "packet-behind",
       .arguments = "[JOINT|off]",
       .means = "the packet that set the shown value of the selection",
       .run = showPacket,
       .needs_log = true},
  };
  for (Command& command : commands) command.group = CommandGroup::picture;
  return commands;
}

}  // namespace rocinante
