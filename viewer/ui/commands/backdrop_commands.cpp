#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "viewer/ui/commands/command_groups.h"

namespace rocinante {
namespace {

Result<BackdropChoice*> backdropOf(const CommandStage& stage) {
  if (stage.model.backdrop) return &*stage.model.backdrop;
  return badWord("there is no backdrop: start with --backdrop");
}

Status switchBackdrop(CommandWords words, const CommandStage& stage) {
  const auto backdrop = backdropOf(stage);
  if (!backdrop.ok()) return backdrop.error();
  const auto on = switched(words, (*backdrop)->shown);
  if (!on.ok()) return on.error();
  (*backdrop)->shown = *on;
  return {};
}

Status setBackdropOpacity(CommandWords words, const CommandStage& stage) {
  const auto backdrop = backdropOf(stage);
  if (!backdrop.ok()) return backdrop.error();
  const auto opacity = numberOf(words[0]);
  if (!opacity.ok()) return opacity.error();
  if (!(*opacity >= 0 && *opacity <= 1)) {
    return badWord(fmt::format("`{}` is not an opacity: give 0 to 1", words[0]));
  }
  (*backdrop)->opacity = *opacity;
  return {};
}

Status setBackdropOffset(CommandWords words, const CommandStage& stage) {
  const auto backdrop = backdropOf(stage);
  if (!backdrop.ok()) return backdrop.error();
  const auto offset = parseDuration(words[0]);
  if (!offset.ok()) return offset.error();
  (*backdrop)->offset = *offset;
  return {};
}

}  // namespace

std::vector<Command> backdropCommands() {
  std::vector<Command> commands{
      {.name = "backdrop",
       .arguments = "[on|off]",
       .means = "the real camera's pictures behind the model",
       .run = switchBackdrop,
       .shortcuts = {{"shift+B", "", ""}}},
      {.name = "backdrop-opacity",
       .arguments = "N",
       .means = "how much of the backdrop covers the model, 0 to 1",
       .run = setBackdropOpacity},
      {.name = "backdrop-offset",
       .arguments = "SECONDS",
       .means = "the session time at which the backdrop begins",
       .run = setBackdropOffset},
  };
  for (Command& command : commands) {
    command.group = CommandGroup::picture;
    command.offered = [](const ViewModel& model) { return model.backdrop.has_value(); };
  }
  return commands;
}

}  // namespace rocinante
