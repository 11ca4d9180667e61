#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/model/view_cube.h"

namespace rocinante {
namespace {

Status useNamedCamera(CommandWords words, const CommandStage& stage) {
  if (FittedCameras::knows(words[0]) && stage.model.scene().findCamera(words[0]) == nullptr) {
    stage.requests.built_in_camera = words[0];
    return {};
  }
  stage.model.useCamera(words[0]);
  stage.model.cameraView();
  return stage.model.viewer.panels.complaint.empty()
             ? Status{}
             : Status{badWord(stage.model.viewer.panels.complaint)};
}

/// A number without a camera does nothing: cells have fewer than nine.
Status useNumberedCamera(CommandWords words, const CommandStage& stage) {
  const auto number = numberOf(words[0]);
  if (!number.ok()) return number.error();
  const std::vector<std::string> cameras = stage.model.cameraNames();
  if (*number < 1 || *number != static_cast<int>(std::min(*number, 1e6))) {
    return badWord(fmt::format("`{}` is not a number of a camera, from 1", words[0]));
  }
  const auto place = static_cast<std::size_t>(*number) - 1;
  if (place < cameras.size()) stage.model.useCamera(cameras[place]);
  return {};
}

Status resetToInitialView(CommandWords /*words*/, const CommandStage& stage) {
  stage.requests.reset = true;
  return {};
}

Status fitView(CommandWords words, const CommandStage& stage) {
  if (!words.empty() && words[0] != "selection") {
    return badWord(fmt::format("`{}` is not `selection`", words[0]));
  }
  (words.empty() ? stage.requests.fit : stage.requests.fit_selected) = true;
  return {};
}

Status orbitView(CommandWords words, const CommandStage& stage) {
  const auto x = numberOf(words[0]);
  const auto y = numberOf(words[1]);
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  stage.model.holdCamera().orbit(*x, *y, stage.height_px);
  return {};
}

Status panView(CommandWords words, const CommandStage& stage) {
  const auto x = numberOf(words[0]);
  const auto y = numberOf(words[1]);
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  stage.model.holdCamera().pan(*x, *y, stage.height_px);
  return {};
}

Status lookFromSide(CommandWords words, const CommandStage& stage) {
  const auto side = viewSideOf(words);
  if (!side) {
    return badWord(fmt::format(
        "the view cannot be from `{}`: use one or more of top or bottom, front or back, "
        "left or right; or isometric",
        fmt::join(words, " ")));
  }
  stage.model.holdCamera().lookFrom(directionFrom(*side));
  return {};
}

Status showViewCube(CommandWords words, const CommandStage& stage) {
  bool& shown = stage.model.viewer.panels.cube_shown;
  const auto on = switched(words, shown);
  if (!on.ok()) return on.error();
  shown = *on;
  return {};
}

std::vector<std::string> sideChoices(const ViewModel& /*model*/) {
  return {"top", "bottom", "front", "back", "left", "right", "isometric"};
}

Status zoomView(CommandWords words, const CommandStage& stage) {
  const auto steps = numberOf(words[0]);
  if (!steps.ok()) return steps.error();
  stage.model.holdCamera().zoom(*steps);
  return {};
}

Status saveCamera(CommandWords words, const CommandStage& stage) {
  stage.requests.save_camera = words[0];
  return {};
}

std::vector<std::string> cameraChoices(const ViewModel& model) {
  std::vector<std::string> names = model.cameraNames();
  for (const char* const built_in : {"fit", "map"}) {
    if (std::ranges::find(names, built_in) == names.end()) names.emplace_back(built_in);
  }
  return names;
}

}  // namespace

std::vector<Command> cameraCommands() {
  std::vector<Command> commands{
      {.name = "camera",
       .arguments = "NAME",
       .means = "a camera of the cell, a view of the session, fit, map, or a viewpoint in numbers",
       .run = useNamedCamera,
       .choices = cameraChoices},
      {.name = "camera-number",
       .arguments = "N",
       .means = "the cameras, in the order of the list",
       .run = useNumberedCamera,
       .shortcuts = {{"1", "1", ""},
                     {"2", "2", ""},
                     {"3", "3", ""},
                     {"4", "4", ""},
                     {"5", "5", ""},
                     {"6", "6", ""},
                     {"7", "7", ""},
                     {"8", "8", ""},
                     {"9", "9", ""}},
       .keys_shown = "1 to 9"},
      {.name = "initial-view",
       .means = "the initial view",
       .run = resetToInitialView,
       .shortcuts = {{"0", "", ""}}},
      {.name = "fit",
       .arguments = "[selection]",
       .means = "everything that can move, or the whole cell",
       .run = fitView,
       .shortcuts = {{"F", "", ""}, {"shift+F", "selection", "the selection, as large as fits"}}},
      {.name = "look",
       .arguments = "SIDE [SIDE] [SIDE]",
       .means = "from the top, bottom, front, back, left, right, from two or three of them, or "
                "isometric",
       .run = lookFromSide,
       .choices = sideChoices},
      {.name = "orbit",
       .arguments = "DX DY",
       .means = "turn about the target, as a drag by pixels",
       .run = orbitView},
      {.name = "pan", .arguments = "DX DY", .means = "pan, as a drag by pixels", .run = panView},
      {.name = "save-camera",
       .arguments = "NAME",
       .means = "append the view to the cell, as a camera",
       .run = saveCamera},
      {.name = "view-cube",
       .arguments = "[on|off]",
       .means = "the cube whose sides turn the view",
       .run = showViewCube},
      {.name = "zoom", .arguments = "STEPS", .means = "zoom, as the wheel", .run = zoomView},
  };
  for (Command& command : commands) command.group = CommandGroup::camera;
  return commands;
}

}  // namespace rocinante
