#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/duration_text.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/model/applied_layout.h"
#include "viewer/ui/model/dock_layout.h"

namespace rocinante {

Error badWord(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

Result<KeyPress> keyOf(const std::string& word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kOfTables{
      {{"esc", "escape"}, {"comma", ","}, {"full-stop", "."}}};
  std::string name;
  for (const char one : word) name += one >= 'A' && one <= 'Z' ? static_cast<char>(one + 32) : one;
  bool control = false, shift = false;
  const auto takes = [&name](std::string_view prefix, bool& has) {
    if (has || !name.starts_with(prefix)) return false;
    name.erase(0, prefix.size());
    return has = true;
  };
  while (takes("ctrl+", control) || takes("shift+", shift)) continue;
  for (const auto& [of_table, meant] : kOfTables) {
    if (name == of_table) name = meant;
  }
  auto press = parseKey(name);
  if (!press) {
    // A letter, or F1.
    for (char& one : name) one = one >= 'a' && one <= 'z' ? static_cast<char>(one - 32) : one;
    press = parseKey(name);
  }
  if (!press || press->control || press->shift) {
    return badWord(fmt::format("`{}` is not a key: use G, ctrl+G, shift+left or enter", word));
  }
  press->control = control;
  press->shift = shift;
  return *press;
}

Result<double> numberOf(const std::string& word) {
  double value = 0;
  const auto [stop, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc{} || stop != word.data() + word.size() || !std::isfinite(value)) {
    return badWord(fmt::format("`{}` is not a number", word));
  }
  return value;
}

Result<bool> switched(CommandWords words, bool now) {
  if (words.empty()) return !now;
  if (words[0] == "on") return true;
  if (words[0] == "off") return false;
  return badWord(fmt::format("`{}` is neither on nor off", words[0]));
}

namespace {

namespace fs = std::filesystem;

Status makeEvidence(CommandWords words, const CommandStage& stage) {
  if (words.empty()) {
    stage.requests.evidence = true;
  } else {
    stage.requests.evidence_file = words[0];
  }
  return {};
}

Status makeVideo(CommandWords words, const CommandStage& stage) {
  stage.requests.video = words.empty() ? std::string() : words[0];
  return {};
}

Status addGoldenCase(CommandWords words, const CommandStage& stage) {
  stage.requests.golden_case = {words.empty() ? std::string() : words[0],
                                words.size() < 2 ? "view.suite.toml" : words[1]};
  return {};
}

Status makeScreenshot(CommandWords words, const CommandStage& stage) {
  stage.requests.screenshot = words[0];
  return {};
}

Status measureLegibility(CommandWords words, const CommandStage& stage) {
  stage.requests.legibility = words[0];
  return {};
}

Status setPanels(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, stage.model.viewer.panels.shown);
  if (!on.ok()) return on.error();
  stage.model.viewer.panels.shown = *on;
  return {};
}

Status setHelp(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, stage.model.viewer.panels.help_shown);
  if (!on.ok()) return on.error();
  stage.model.viewer.panels.help_shown = *on;
  return {};
}

Status setPalette(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, stage.model.viewer.panels.palette.shown);
  if (!on.ok()) return on.error();
  stage.model.viewer.panels.palette.shown = false;
  if (*on) stage.model.viewer.panels.palette.open();
  return {};
}

Status openFile(CommandWords words, const CommandStage& stage) {
  if (words.empty()) {
    std::error_code ignored;
    stage.model.viewer.panels.open.open(std::filesystem::current_path(ignored));
  } else {
    stage.requests.open = {words[0]};
  }
  return {};
}

Status setTheme(CommandWords words, const CommandStage& stage) {
  if (!words.empty() && words[0] != "dark" && words[0] != "light") {
    return badWord(fmt::format("`{}` is neither dark nor light", words[0]));
  }
  stage.model.viewer.panels.is_light =
      words.empty() ? !stage.model.viewer.panels.is_light : words[0] == "light";
  return {};
}

Status foldEdge(CommandWords words, const CommandStage& stage) {
  PanelPlaces& places = stage.model.viewer.panels.places;
  for (const DockEdge edge : {DockEdge::left, DockEdge::right, DockEdge::bottom}) {
    if (words[0] != nameOf(edge)) continue;
    const std::string name = nameOf(edge);
    bool& collapsed = places.places[name].collapsed;
    const bool is_folded = places.peeked != name && (collapsed || places.strips.contains(name));
    const auto on = switched(words.subspan(1), is_folded);
    if (!on.ok()) return on.error();
    collapsed = *on;
    // Where there is no room for it, it is looked at over the picture, as by a click on its strip.
    places.peeked = *on ? std::string() : name;
    return {};
  }
  return badWord(fmt::format("`{}` is not left, right or bottom", words[0]));
}

Status setPictureWidth(CommandWords words, const CommandStage& stage) {
  if (words[0] == "seen") {
    stage.model.viewer.made_width.reset();
    return {};
  }
  const auto width = numberOf(words[0]);
  if (!width.ok()) return width.error();
  if (*width < kLeastMadeWidth || *width > kMostMadeWidth || *width != std::floor(*width)) {
    return badWord(fmt::format("a picture's width is {} to {} pixels, not {}", kLeastMadeWidth,
                               kMostMadeWidth, words[0]));
  }
  stage.model.viewer.made_width = static_cast<int>(*width);
  return {};
}

Status useLayout(CommandWords words, const CommandStage& stage) {
  const auto layout = ViewLayout::load(words[0]);
  if (!layout.ok()) return layout.error();
  noteLeftOut(words[0], applyLayout(*layout, stage.model), stage.model);
  // Now, as by `camera`: commands that follow are of this view, or choose another.
  if (std::string& wanted = stage.model.viewer.built_in_wanted; !wanted.empty()) {
    stage.requests.built_in_camera = std::exchange(wanted, {});
  }
  return {};
}

Status saveLayout(CommandWords words, const CommandStage& stage) {
  fs::path file = words[0];
  if (!file.native().ends_with(".layout.toml")) file += ".layout.toml";
  return layoutOf(stage.model).save(file);
}

Status resetPanels(CommandWords /*words*/, const CommandStage& stage) {
  stage.model.viewer.panels.places = PanelPlaces();
  return {};
}

/// The tabs that there are now, as `tab` names them.
std::vector<std::string> tabChoices(const ViewModel& model) {
  std::vector<std::string> tabs{"scene", "look"};
  if (model.isLive()) tabs.emplace_back("sources");
  if (model.cursor() != nullptr) tabs.insert(tabs.end(), {"events", "check"});
  tabs.emplace_back("frame");
  return tabs;
}

Status openTab(CommandWords words, const CommandStage& stage) {
  const std::vector<std::string> tabs = tabChoices(stage.model);
  if (std::ranges::find(tabs, words[0]) == tabs.end()) {
    return badWord(
        fmt::format("there is no tab `{}` now; there are {}", words[0], fmt::join(tabs, ", ")));
  }
  std::string name = words[0];
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  stage.model.viewer.panels.openTab(std::move(name));
  return {};
}

Status quitProgram(CommandWords /*words*/, const CommandStage& stage) {
  stage.requests.close = true;
  return {};
}

Status pointAt(CommandWords words, const CommandStage& stage) {
  const auto x = numberOf(words[0]);
  const auto y = numberOf(words[1]);
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  if (!stage.model.publishing.points()) return badWord("no pointer is published to others");
  stage.requests.point = PictureClick{*x, *y, false};
  return {};
}

Status clickPicture(CommandWords words, const CommandStage& stage) {
  const auto x = numberOf(words[0]);
  const auto y = numberOf(words[1]);
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  stage.requests.click = PictureClick{*x, *y, false};
  return {};
}

Status pressKey(CommandWords words, const CommandStage& stage) {
  const auto press = keyOf(words[0]);
  if (!press.ok()) return press.error();
  return runKey(*press, stage);
}

Status drawFrames(const std::string& word, double frames_per_unit, const CommandStage& stage) {
  const auto count = numberOf(word);
  if (!count.ok()) return count.error();
  stage.requests.frames = static_cast<int>(std::min(std::max(*count * frames_per_unit, 1.0), 1e6));
  return {};
}

Status drawFrameCount(CommandWords words, const CommandStage& stage) {
  return drawFrames(words[0], 1, stage);
}

Status drawSeconds(CommandWords words, const CommandStage& stage) {
  return drawFrames(words[0], 60, stage);
}

Status awaitLength(CommandWords words, const CommandStage& stage) {
  const auto length = parseDuration(words[0]);
  if (!length.ok()) return length.error();
  stage.requests.await_length = *length;
  return {};
}

Status awaitLine(CommandWords words, const CommandStage& stage) {
  stage.requests.await_line = fmt::format("{}", fmt::join(words, " "));
  return {};
}

}  // namespace

std::vector<Command> programCommands() {
  std::vector<Command> commands{
      {.name = "evidence",
       .arguments = "[FILE]",
       .means = "the same picture, drawn by `rocinante render`",
       .run = makeEvidence,
       .shortcuts = {{"S", "", "an evidence picture"}}},
      {.name = "video",
       .arguments = "[FILE]",
       .means = "the part from A to B as a video, drawn by `rocinante render`",
       .run = makeVideo,
       .shortcuts = {{"shift+V", "", "a video of the part"}},
       .needs_log = true},
      {.name = "golden-case",
       .arguments = "[NAME] [SUITE]",
       .means = "the view as a case of a suite, view.suite.toml by default",
       .run = addGoldenCase,
       .shortcuts = {{"shift+G", "", "a golden case"}}},
      {.name = "picture-width",
       .arguments = "PIXELS|seen",
       .means = "the width of what evidence, video and golden-case draw, of the picture's shape",
       .run = setPictureWidth},
      {.name = "screenshot",
       .arguments = "FILE",
       .means = "draw a frame and write it as PNG, panels included",
       .run = makeScreenshot},
      {.name = "panels",
       .arguments = "[on|off]",
       .means = "hide or show the panels",
       .run = setPanels,
       .shortcuts = {{"tab", "", ""}}},
      {.name = "fold",
       .arguments = "left|right|bottom [on|off]",
       .means = "fold the panels of an edge of the window, or open them",
       .run = foldEdge,
       .choices =
           [](const ViewModel&) {
             return std::vector<std::string>{"left", "right", "bottom"};
           }},
      {.name = "layout",
       .arguments = "FILE",
       .means = "panels, curves, insets and camera as a NAME.layout.toml has them",
       .run = useLayout},
      {.name = "save-layout",
       .arguments = "NAME",
       .means = "write those into NAME.layout.toml",
       .run = saveLayout},
      {.name = "tab",
       .arguments = "NAME",
       .means = "a tab of the left panel: scene, look, sources, events, check or frame",
       .run = openTab,
       .choices = tabChoices},
      {.name = "reset-panels", .means = "reset the panels' layout", .run = resetPanels},
      {.name = "theme",
       .arguments = "[dark|light]",
       .means = "dark or light panels",
       .run = setTheme},
      {.name = "help",
       .arguments = "[on|off]",
       .means = "show all keys and commands over the picture",
       .run = setHelp,
       .shortcuts = {{"F1", "", ""}},
       .keys_shown = "? or F1"},
      {.name = "open",
       .arguments = "[FILE]",
       .means = "open a cell, a model or a log",
       .run = openFile,
       .shortcuts = {{"ctrl+O", "", ""}}},
      {.name = "palette",
       .arguments = "[on|off]",
       .means = "find a command and run it",
       .run = setPalette,
       .shortcuts = {{"ctrl+P", "", ""}}},
      {.name = "quit", .means = "close", .run = quitProgram, .shortcuts = {{"Q", "", ""}}},
  };
  for (Command& command : commands) command.group = CommandGroup::program;
  return commands;
}

std::vector<Command> scriptCommands() {
  std::vector<Command> commands{
      {.name = "click",
       .arguments = "X Y",
       .means = "click the picture, in pixels from its top left",
       .run = clickPicture},
      {.name = "point-at",
       .arguments = "X Y",
       .means = "point others there, in pixels from the picture's top left",
       .run = pointAt},
      {.name = "key", .arguments = "KEY", .means = "press a key", .run = pressKey},
      {.name = "frame", .arguments = "N", .means = "draw N frames", .run = drawFrameCount},
      {.name = "wait",
       .arguments = "SECONDS",
       .means = "draw 60 frames for each second",
       .run = drawSeconds},
      {.name = "legibility",
       .arguments = "FILE",
       .means = "how the panels of the last frame can be read, as CSV",
       .run = measureLegibility},
      {.name = "await",
       .arguments = "TIME",
       .means = "wait until the growing session is this long",
       .run = awaitLength},
      {.name = "await-line",
       .arguments = "[TEXT...]",
       .means = "wait until a line over the picture has this text, or until there is none",
       .run = awaitLine},
  };
  for (Command& command : commands) command.group = CommandGroup::script;
  return commands;
}

}  // namespace rocinante
