#include <fmt/format.h>

#include <filesystem>

#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

void showOpenList(ViewModel& model) {
  std::error_code ignored;
  model.viewer.panels.open.open(std::filesystem::current_path(ignored));
}

Status connect(CommandWords words, const CommandStage& stage) {
  if (words.empty()) {
    showOpenList(stage.model);
  } else {
    stage.requests.connect.assign(words.begin(), words.end());
    stage.requests.await_files = true;
  }
  return {};
}

Status goToLive(CommandWords /*words*/, const CommandStage& stage) {
  stage.requests.to_live = true;
  stage.requests.await_files = true;
  return {};
}

Status disconnect(CommandWords words, const CommandStage& stage) {
  if (!words.empty() && words[0] != "forget") {
    return badWord(fmt::format("`{}` is not forget", words[0]));
  }
  stage.requests.disconnect = !words.empty();
  stage.requests.await_files = true;
  return {};
}

/// A script has what was heard when it goes on; a person sees it in the list.
Status listenAround(CommandWords /*words*/, const CommandStage& stage) {
  stage.model.listenAround();
  if (!stage.model.study_waits) {
    showOpenList(stage.model);
    return {};
  }
  std::string heard;
  for (const HeardEndpoint& one : stage.model.survey()->heard()) {
    heard += fmt::format("{}{}: {}", heard.empty() ? "" : "\n", one.endpoint, one.text());
  }
  stage.requests.notice = heard;
  return {};
}

/// The usual endpoints, and those of sessions that were left.
std::vector<std::string> endpointChoices(const ViewModel& model) {
  std::vector<std::string> choices = model.viewer.panels.open.left;
  for (const SurveyedEndpoint& usual : usualEndpoints()) choices.push_back(usual.endpoint.text());
  return choices;
}

bool hasLeftLive(const ViewModel& model) { return !model.viewer.panels.open.left.empty(); }

}  // namespace

std::vector<Command> connectCommands() {
  std::vector<Command> commands{
      {.name = "connect",
       .arguments = "[EP...]",
       .means = "listen at endpoints, with the cell that is shown",
       .run = connect,
       .choices = endpointChoices},
      {.name = "listen",
       .means = "what is heard at the usual endpoints, in two seconds",
       .run = listenAround},
      {.name = "live",
       .means = "back to the live session that goes on behind what is shown",
       .run = goToLive,
       .offered = hasLeftLive},
      {.name = "disconnect",
       .arguments = "[forget]",
       .means = "end a live session; forget: with what it kept",
       .run = disconnect,
       .offered = [](const ViewModel& model) { return model.isLive() || hasLeftLive(model); }},
  };
  for (Command& command : commands) command.group = CommandGroup::program;
  return commands;
}

}  // namespace rocinante
