#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

WallTime wallNow() { return std::chrono::system_clock::now(); }

Status needsPublishing(const CommandStage& stage) {
  if (stage.model.publishing.active() != nullptr) return {};
  return badWord("nothing is published to others: begin with `publish EP,NAME`");
}

std::string joined(CommandWords words) { return fmt::format("{}", fmt::join(words, " ")); }

Status publishView(CommandWords words, const CommandStage& stage) {
  const std::string& word = words[0];
  if (word == "off") {
    stage.model.publishing.end(stage.now, wallNow());
    return {};
  }
  const std::size_t comma = word.rfind(',');
  if (comma == std::string::npos) {
    return badWord(fmt::format("`{}` is not EP,NAME: others need a name for this window", word));
  }
  return stage.model.publishing.begin(word.substr(0, comma), word.substr(comma + 1), stage.now,
                                      wallNow());
}

Status setPointer(CommandWords words, const CommandStage& stage) {
  if (Status ready = needsPublishing(stage); !ready) return ready;
  const auto on = switched(words, stage.model.publishing.points());
  if (!on.ok()) return on.error();
  stage.model.publishing.setPointer(*on);
  return {};
}

Status drawForOthers(CommandWords words, const CommandStage& stage) {
  Publishing& publishing = stage.model.publishing;
  if (Status ready = needsPublishing(stage); !ready) return ready;
  if (!words.empty() && words[0] == "none") {
    publishing.eraseDrawn();
    return {};
  }
  const auto on = switched(words, publishing.drawsLine());
  if (!on.ok()) return on.error();
  *on ? publishing.beginLine() : publishing.endClicks();
  return {};
}

Status labelForOthers(CommandWords words, const CommandStage& stage) {
  if (Status ready = needsPublishing(stage); !ready) return ready;
  stage.model.publishing.beginLabel(joined(words));
  return {};
}

Status sayToOthers(CommandWords words, const CommandStage& stage) {
  if (Status ready = needsPublishing(stage); !ready) return ready;
  stage.model.publishing.say(joined(words));
  return {};
}

std::vector<std::string> viewChoices(const ViewModel& model) { return model.viewsOfOthers(); }

Status watchOther(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  const std::vector<std::string> views = model.viewsOfOthers();
  const auto watched = std::ranges::find(views, model.watched());
  if (words.empty()) {
    if (views.empty()) return badWord("nobody publishes a viewpoint in this session");
    const auto next = watched == views.end() ? views.begin() : std::next(watched);
    next == views.end() ? model.stopWatching() : model.useCamera(*next);
    return {};
  }
  if (words[0] == "off") {
    model.stopWatching();
    return {};
  }
  if (std::ranges::find(views, words[0]) == views.end()) {
    return badWord(
        fmt::format("nobody publishes a viewpoint `{}`; there {}", words[0],
                    views.empty() ? "are none" : fmt::format("are: {}", fmt::join(views, ", "))));
  }
  model.useCamera(words[0]);
  return {};
}

bool isPublishing(const ViewModel& model) { return model.publishing.active() != nullptr; }

}  // namespace

std::vector<Command> publishCommands() {
  std::vector<Command> commands{
      {.name = "publish",
       .arguments = "EP,NAME|off",
       .means = "let other windows see where this one looks and points",
       .run = publishView},
      {.name = "watch",
       .arguments = "[NAME|off]",
       .means = "see what another window sees; the next one's view, then one's own",
       .run = watchOther,
       .shortcuts = {{"Z", "", ""}},
       .offered = [](const ViewModel& model) { return !model.viewsOfOthers().empty(); },
       .choices = viewChoices},
      {.name = "pointer",
       .arguments = "[on|off]",
       .means = "others see where the mouse points",
       .run = setPointer,
       .offered = isPublishing},
      {.name = "draw",
       .arguments = "[on|off|none]",
       .means = "clicks draw a line that others see; none: erase what was drawn",
       .run = drawForOthers,
       .offered = isPublishing},
      {.name = "label",
       .arguments = "TEXT...",
       .means = "a text that others see, where the next click is",
       .run = labelForOthers,
       .offered = isPublishing},
      {.name = "say",
       .arguments = "TEXT...",
       .means = "an event that others see",
       .run = sayToOthers,
       .offered = isPublishing},
  };
  for (Command& command : commands) command.group = CommandGroup::picture;
  return commands;
}

}  // namespace rocinante
