#include <fmt/format.h>

#include <algorithm>

#include "viewer/detail/detail_level.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// Adds the entry, or removes the one of the same path.
template <class Entry, class PathOf>
void toggleEntry(std::vector<Entry>& entries, Entry entry, const PathOf& path_of) {
  const auto found = std::ranges::find(entries, path_of(entry), path_of);
  if (found == entries.end()) {
    entries.push_back(std::move(entry));
  } else {
    entries.erase(found);
  }
}

/// The selection, else every device.
std::string subjectOf(const ViewModel& model) {
  return model.selected.device.empty() ? "*" : model.selected.path();
}

const std::string& itself(const std::string& path) { return path; }

Status setEdges(CommandWords words, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  if (words.empty()) {
    style.edges = static_cast<EdgeStyle>((static_cast<int>(style.edges) + 1) % 3);
  } else if (auto set = setStyle(style, "edges", words[0]); !set) {
    return badWord(set.error().text());
  }
  stage.model.setStyle(style);
  return {};
}

Status setFlag(bool RenderStyle::*flag, CommandWords words, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  const auto on = switched(words, style.*flag);
  if (!on.ok()) return on.error();
  style.*flag = *on;
  stage.model.setStyle(style);
  return {};
}

Status setShadows(CommandWords words, const CommandStage& stage) {
  return setFlag(&RenderStyle::shadows, words, stage);
}

Status setContact(CommandWords words, const CommandStage& stage) {
  return setFlag(&RenderStyle::contact, words, stage);
}

Status setLimits(CommandWords words, const CommandStage& stage) {
  return setFlag(&RenderStyle::limits, words, stage);
}

Status toggleWireframe(CommandWords /*words*/, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  toggleEntry(style.wireframe, subjectOf(stage.model), itself);
  stage.model.setStyle(style);
  return {};
}

Status toggleCollision(CommandWords /*words*/, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  toggleEntry(style.collision, subjectOf(stage.model), itself);
  stage.model.setStyle(style);
  return {};
}

Status toggleTransparent(CommandWords /*words*/, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  toggleEntry(style.transparent, TransparentStyle{subjectOf(stage.model), 0.3},
              [](const TransparentStyle& one) -> const std::string& { return one.path; });
  stage.model.setStyle(style);
  return {};
}

Status toggleTrail(CommandWords /*words*/, const CommandStage& stage) {
  if (stage.model.selected.device.empty()) return {};
  RenderStyle style = stage.model.style();
  toggleEntry(style.trails, TrailStyle{stage.model.selected.path(), 5s},
              [](const TrailStyle& one) -> const std::string& { return one.path; });
  stage.model.setStyle(style);
  return {};
}

Status setOneStyle(CommandWords words, const CommandStage& stage) {
  RenderStyle style = stage.model.style();
  // What the window chose by itself gives way.
  if (stage.model.hasLooksByDefault() && words[0] == "shading" && words[1] == "plain") {
    style.shadows = style.contact = false;
  }
  Status set = setStyle(style, words[0], words[1]);
  if (set) set = stage.model.names().check(style);
  if (!set) return badWord(set.error().text());
  stage.model.setStyle(style);
  return {};
}

Status setVisibility(const std::string& path, std::optional<bool> visible,
                     const CommandStage& stage) {
  if (auto known = stage.model.names().check({path}); !known) return badWord(known.error().text());
  if (stage.model.setVisible(path, visible)) return {};
  return badWord(fmt::format("`{}` is not DEVICE, DEVICE/LINK or layer/NAME", path));
}

Status hidePath(CommandWords words, const CommandStage& stage) {
  if (!words.empty()) return setVisibility(words[0], false, stage);
  if (!stage.model.selected.device.empty()) {
    stage.model.setVisible(stage.model.selected.path(), false);
  }
  return {};
}

Status showPath(CommandWords words, const CommandStage& stage) {
  if (!words.empty()) return setVisibility(words[0], true, stage);
  for (const std::string& path : stage.model.hiddenPaths()) {
    stage.model.setVisible(path, std::nullopt);
  }
  return {};
}

Status showOnly(CommandWords words, const CommandStage& stage) {
  const std::string path =
      words.empty() ? Selection{stage.model.selected.device, ""}.path() : words[0];
  if (path.empty()) return badWord("nothing is selected");
  if (stage.model.showOnly(path)) return {};
  return badWord(fmt::format("no device is called `{}`", path));
}

Status autoPath(CommandWords words, const CommandStage& stage) {
  return setVisibility(words[0], std::nullopt, stage);
}

Status selectPath(CommandWords words, const CommandStage& stage) {
  if (auto known = stage.model.names().check({words[0]}); !known) {
    return badWord(known.error().text());
  }
  const std::size_t slash = words[0].find('/');
  stage.model.selected.device = words[0].substr(0, slash);
  stage.model.selected.link = slash == std::string::npos ? "" : words[0].substr(slash + 1);
  return {};
}

Status clearSelection(CommandWords /*words*/, const CommandStage& stage) {
  ViewModel& model = stage.model;
  if (model.hand.driving() != nullptr) {
    model.hand.stopDriving();
  } else if (model.viewer.panels.palette.shown || model.viewer.panels.open.shown ||
             model.viewer.panels.help_shown) {
    model.viewer.panels.palette.shown = model.viewer.panels.open.shown =
        model.viewer.panels.help_shown = false;
  } else if (!model.viewer.panels.notes.empty()) {
    model.viewer.panels.notes.clear();
  } else if (model.viewer.picking.active()) {
    model.viewer.picking.end();
  } else if (model.publishing.takesClicks()) {
    model.publishing.endClicks();
  } else {
    model.selected = {};
  }
  return {};
}

Status dismissLines(CommandWords /*words*/, const CommandStage& stage) {
  stage.model.viewer.panels.notices.dismissAll();
  stage.model.viewer.panels.notes.clear();
  return {};
}

Status setInsets(CommandWords words, const CommandStage& stage) {
  const bool any = std::ranges::any_of(stage.model.viewer.insets, &InsetChoice::shown);
  const auto on = switched(words, any);
  if (!on.ok()) return on.error();
  for (InsetChoice& inset : stage.model.viewer.insets) inset.shown = *on;
  return {};
}

/// The inset of a number from 1.
Result<std::size_t> insetOf(const std::string& word, const ViewModel& model) {
  const auto number = numberOf(word);
  if (!number.ok()) return number.error();
  if (*number < 1 || *number > static_cast<double>(model.viewer.insets.size()) ||
      *number != std::floor(*number)) {
    return badWord(fmt::format(
        "there is no inset {}, but {}", word,
        model.viewer.insets.empty() ? "none" : fmt::format("1 to {}", model.viewer.insets.size())));
  }
  return static_cast<std::size_t>(*number) - 1;
}

/// Sets corner or size by what parseInset() takes.
Status changeInset(CommandWords words, const CommandStage& stage) {
  const auto number = insetOf(words[0], stage.model);
  if (!number.ok()) return number.error();
  CellInset& inset = stage.model.viewer.insets[*number].inset;
  const auto asked = parseInset("x:" + words[1]);
  if (!asked.ok() || asked->camera != "x") {
    return badWord(fmt::format(
        "`{}` is neither a corner, as top-left, nor a size, as 0.3x0.2 or 160x120px", words[1]));
  }
  if (words[1].find_first_of("0123456789") == std::string::npos) {
    inset.corner = asked->corner;
    return {};
  }
  inset.width = asked->width;
  inset.height = asked->height;
  inset.in_pixels = asked->in_pixels;
  return {};
}

Status swapWithInset(CommandWords words, const CommandStage& stage) {
  const auto number = insetOf(words.empty() ? "1" : words[0], stage.model);
  if (!number.ok()) return number.error();
  return swapInset(stage.model, *number);
}

Status setDetail(CommandWords words, const CommandStage& stage) {
  stage.requests.rung = words[0] == "auto" ? std::optional(-1) : parseDetailRung(words[0]);
  if (stage.requests.rung) return {};
  return badWord(
      fmt::format("`{}` is not a level of detail from 0 to {}, or auto", words[0], kCoarsestRung));
}

std::vector<std::string> deviceChoices(const ViewModel& model) {
  std::vector<std::string> names;
  for (const PosedDevice& device : model.scene().devices) {
    names.push_back(Selection{device.name, ""}.path());
  }
  return names;
}

std::vector<std::string> detailChoices(const ViewModel& /*model*/) {
  std::vector<std::string> levels;
  for (int level = 0; level <= kCoarsestRung; ++level) levels.push_back(fmt::format("{}", level));
  return levels;
}

}  // namespace

std::vector<Command> pictureCommands() {
  std::vector<Command> commands{
      {.name = "edges",
       .arguments = "[off|on|only]",
       .means = "edges off, on, only",
       .run = setEdges,
       .shortcuts = {{"E", "", ""}}},
      {.name = "shadows",
       .arguments = "[on|off]",
       .means = "shadows",
       .run = setShadows,
       .shortcuts = {{"D", "", ""}}},
      {.name = "contact",
       .arguments = "[on|off]",
       .means = "darker where surfaces are near each other",
       .run = setContact},
      {.name = "limits",
       .arguments = "[on|off]",
       .means = "links near a joint limit amber, beyond it red",
       .run = setLimits,
       .shortcuts = {{"L", "", ""}}},
      {.name = "wireframe",
       .means = "the selection, else everything, as lines",
       .run = toggleWireframe,
       .shortcuts = {{"W", "", ""}}},
      {.name = "see-through",
       .means = "the selection, else everything, see-through",
       .run = toggleTransparent,
       .shortcuts = {{"T", "", ""}}},
      {.name = "collision",
       .means = "collision geometry of the selection, else of everything",
       .run = toggleCollision,
       .shortcuts = {{"C", "", ""}}},
      {.name = "trail",
       .means = "the trail of the selection",
       .run = toggleTrail,
       .shortcuts = {{"R", "", ""}}},
      {.name = "hide",
       .arguments = "[PATH]",
       .means = "hide the selection or PATH",
       .run = hidePath,
       .shortcuts = {{"H", "", "hide the selection"}},
       .choices = deviceChoices},
      {.name = "show",
       .arguments = "[PATH]",
       .means = "show PATH, or all that was hidden",
       .run = showPath,
       .shortcuts = {{"shift+H", "", "show all that was hidden"}},
       .choices = deviceChoices},
      {.name = "only",
       .arguments = "[DEVICE]",
       .means = "hide all devices but the selected one or DEVICE",
       .run = showOnly,
       .choices = deviceChoices},
      {.name = "auto",
       .arguments = "PATH",
       .means = "visibility as packets and the cell have it",
       .run = autoPath,
       .choices = deviceChoices},
      {.name = "select",
       .arguments = "DEVICE[/LINK]",
       .means = "select a device or link",
       .run = selectPath,
       .choices = deviceChoices},
      {.name = "clear",
       .means =
           "end driving, else close what is open, else dismiss notes, else clear the selection",
       .run = clearSelection,
       .shortcuts = {{"escape", "", ""}}},
      {.name = "dismiss", .means = "dismiss the lines over the picture", .run = dismissLines},
      {.name = "insets",
       .arguments = "[on|off]",
       .means = "insets on or off",
       .run = setInsets,
       .shortcuts = {{"I", "", ""}}},
      {.name = "inset",
       .arguments = "N CORNER|SIZE",
       .means = "an inset's corner, as top-left, or size, as 0.3x0.2 or 160x120px",
       .run = changeInset},
      {.name = "swap-inset",
       .arguments = "[N]",
       .means = "an inset's view in place of the picture's, and the other way round",
       .run = swapWithInset,
       .shortcuts = {{"shift+I", "", "the first inset's view and the picture's, swapped"}},
       .offered = [](const ViewModel& model) { return !model.viewer.inset_places.empty(); }},
      {.name = "style",
       .arguments = "KEY VALUE",
       .means = "a look of the picture, as --style",
       .run = setOneStyle},
      {.name = "detail",
       .arguments = "LEVEL|auto",
       .means = "a fixed level of detail, or as --target-fps allows",
       .run = setDetail,
       .choices = detailChoices},
  };
  for (Command& command : commands) command.group = CommandGroup::picture;
  return commands;
}

}  // namespace rocinante
