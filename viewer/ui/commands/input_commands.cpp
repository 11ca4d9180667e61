#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/duration_text.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/commands/script_word.h"

namespace rocinante {
namespace {

/// Beyond any window, and small enough for arithmetic with floats.
constexpr double kFarthestPx = 100'000;
constexpr double kMostSteps = 1'000;
constexpr int kLargestPx = 8192;

/// A number between these bounds.
Result<double> numberWithin(const std::string& word, double least, double most) {
  const auto number = numberOf(word);
  if (!number.ok()) return number;
  if (*number < least || *number > most) {
    return badWord(fmt::format("`{}` must be from {} to {}", word, least, most));
  }
  return number;
}

Status moveMouse(CommandWords words, const CommandStage& stage) {
  const auto x = numberWithin(words[0], -kFarthestPx, kFarthestPx);
  if (!x.ok()) return x.error();
  const auto y = numberWithin(words[1], -kFarthestPx, kFarthestPx);
  if (!y.ok()) return y.error();
  stage.input->mouse = {*x, *y};
  return {};
}

Status takeMouseOut(CommandWords /*words*/, const CommandStage& stage) {
  stage.input->mouse.reset();
  return {};
}

Status changeButton(CommandWords words, const CommandStage& stage) {
  const auto number = std::ranges::find(kMouseButtons, words[0]) - kMouseButtons.begin();
  if (static_cast<std::size_t>(number) == kMouseButtons.size()) {
    return badWord(
        fmt::format("`{}` is not a button: {}", words[0], fmt::join(kMouseButtons, ", ")));
  }
  if (words[1] != "down" && words[1] != "up") {
    return badWord(fmt::format("`{}` is neither down nor up", words[1]));
  }
  if (words.size() > 2 && (words[1] != "down" || words[2] != "again")) {
    return badWord("only a button that goes down can go down `again`");
  }
  stage.input->again = stage.input->again || words.size() > 2;
  stage.input->down[static_cast<std::size_t>(number)] = words[1] == "down";
  return {};
}

Status turnWheel(CommandWords words, const CommandStage& stage) {
  const auto steps = numberWithin(words[0], -kMostSteps, kMostSteps);
  if (!steps.ok()) return steps.error();
  const auto across =
      words.size() < 2 ? Result<double>(0.0) : numberWithin(words[1], -kMostSteps, kMostSteps);
  if (!across.ok()) return across.error();
  stage.input->wheel = *steps;
  stage.input->wheel_across = *across;
  return {};
}

Status pressHere(CommandWords words, const CommandStage& stage) {
  auto press = keyOf(words[0]);
  if (!press.ok()) return press.error();
  if (words.size() > 1 && words[1] != "again") {
    return badWord(fmt::format("`{}` is not `again`", words[1]));
  }
  press->repeated = words.size() > 1;
  stage.input->presses.push_back(*press);
  return {};
}

Status holdKey(const std::string& word, bool down, const CommandStage& stage) {
  const auto press = keyOf(word);
  if (!press.ok()) return press.error();
  if (!isHeldKey(press->key) || press->shift || press->control) {
    return badWord(fmt::format("`{}` means nothing while it is held", word));
  }
  std::vector<int>& held = stage.input->held;
  std::erase(held, press->key);
  if (down) held.insert(std::ranges::upper_bound(held, press->key), press->key);
  return {};
}

Status holdThisKey(CommandWords words, const CommandStage& stage) {
  return holdKey(words[0], true, stage);
}

Status releaseKey(CommandWords words, const CommandStage& stage) {
  return holdKey(words[0], false, stage);
}

Status typeText(CommandWords words, const CommandStage& stage) {
  const auto text = textOfWord(words[0]);
  if (!text.ok()) return text.error();
  stage.input->typed += *text;
  return {};
}

Status setClipboard(CommandWords words, const CommandStage& stage) {
  const auto text = words.empty() ? Result<std::string>(std::string()) : textOfWord(words[0]);
  if (!text.ok()) return text.error();
  stage.input->pasted = *text;
  return {};
}

Status dropFiles(CommandWords words, const CommandStage& stage) {
  for (const std::string& word : words) {
    const auto file = textOfWord(word);
    if (!file.ok()) return file.error();
    stage.requests.open.emplace_back(*file);
  }
  return {};
}

Status awaitFiles(CommandWords /*words*/, const CommandStage& stage) {
  stage.requests.await_files = true;
  return {};
}

Status sizeWindow(CommandWords words, const CommandStage& stage) {
  const auto width = numberWithin(words[0], 1, kLargestPx);
  if (!width.ok()) return width.error();
  const auto height = numberWithin(words[1], 1, kLargestPx);
  if (!height.ok()) return height.error();
  const auto scale = words.size() < 3 ? Result<double>(1.0) : numberWithin(words[2], 1, 4);
  if (!scale.ok()) return scale.error();
  stage.input->width = static_cast<int>(*width);
  stage.input->height = static_cast<int>(*height);
  stage.input->scale = *scale;
  return {};
}

Status drawFrameAt(CommandWords words, const CommandStage& stage) {
  const auto at = parseDuration(words[0]);
  if (!at.ok()) return at.error();
  stage.requests.frame_at = *at;
  return {};
}

/// `input` has no place to go outside of a script.
template <Status (*Run)(CommandWords, const CommandStage&)>
Status inScript(CommandWords words, const CommandStage& stage) {
  if (stage.input == nullptr) return badWord("only a script says what the mouse and keys do");
  return Run(words, stage);
}

}  // namespace

std::vector<Command> inputCommands() {
  std::vector<Command> commands{
      {.name = "mouse",
       .arguments = "X Y",
       .means = "the mouse is there, in pixels from the window's top left",
       .run = inScript<moveMouse>},
      {.name = "mouse-out", .means = "the mouse leaves the window", .run = inScript<takeMouseOut>},
      {.name = "button",
       .arguments = "BUTTON down|up [again]",
       .means = "left, right, middle, fourth or fifth; again: the second one of a double click",
       .run = inScript<changeButton>},
      {.name = "wheel",
       .arguments = "STEPS [ACROSS]",
       .means = "turn the wheel where the mouse is",
       .run = inScript<turnWheel>},
      {.name = "press",
       .arguments = "KEY [again]",
       .means = "a key of the keyboard; again: because it is held",
       .run = inScript<pressHere>},
      {.name = "hold",
       .arguments = "KEY",
       .means = "a key goes down: shift, ctrl, alt, one that edits text or flies",
       .run = inScript<holdThisKey>},
      {.name = "release",
       .arguments = "KEY",
       .means = "release a key",
       .run = inScript<releaseKey>},
      {.name = "type",
       .arguments = "TEXT",
       .means = "type; a space is %20",
       .run = inScript<typeText>},
      {.name = "clipboard",
       .arguments = "[TEXT]",
       .means = "what a key of the coming frame pastes; a space is %20",
       .run = inScript<setClipboard>},
      {.name = "drop",
       .arguments = "FILE...",
       .means = "drop files on the window",
       .run = inScript<dropFiles>},
      {.name = "await-files",
       .means = "wait until dropped files are shown",
       .run = inScript<awaitFiles>},
      {.name = "window-size",
       .arguments = "WIDTH HEIGHT [SCALE]",
       .means = "the picture's pixels, and the scale of its text",
       .run = inScript<sizeWindow>},
      {.name = "frame-at",
       .arguments = "TIME",
       .means = "draw a frame at this time since the script began",
       .run = inScript<drawFrameAt>},
  };
  for (Command& command : commands) command.group = CommandGroup::script;
  return commands;
}

}  // namespace rocinante
