#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

Status goToNow(CommandWords /*words*/, const CommandStage& stage) {
  const bool drives = stage.model.hand.driving() != nullptr;
  stage.model.hand.stopDriving();
  if (stage.model.goToNow() || drives) return {};
  return badWord("`now` needs a growing session");
}

Status saveSession(CommandWords words, const CommandStage& stage) {
  if (words.empty()) {
    stage.requests.save_live = true;
  } else {
    stage.requests.save_file = words[0];
  }
  return {};
}

}  // namespace

std::vector<Command> liveCommands() {
  std::vector<Command> commands{
      {.name = "now",
       .means = "now, of a growing session; ends driving",
       .run = goToNow,
       .shortcuts = {{"N", "", ""}}},
      {.name = "save",
       .arguments = "[FILE]",
       .means = "save the live session as a log",
       .run = saveSession,
       .shortcuts = {{"shift+S", "", ""}}},
  };
  for (Command& command : commands) {
    command.group = CommandGroup::time;
    command.offered = [](const ViewModel& model) {
      return model.isLive() || (model.session() != nullptr && model.session()->log().growing());
    };
  }
  return commands;
}

}  // namespace rocinante
