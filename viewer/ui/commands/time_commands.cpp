#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/model/wall_clock.h"

namespace rocinante {
namespace {

// Commands that need a log find a cursor: runCommand() has checked it.
TimelineCursor& cursorOf(const CommandStage& stage) { return *stage.model.cursor(); }

Status playPause(CommandWords /*words*/, const CommandStage& stage) {
  cursorOf(stage).toggle(stage.now);
  return {};
}

Status playLog(CommandWords /*words*/, const CommandStage& stage) {
  cursorOf(stage).play(stage.now);
  return {};
}

Status pauseLog(CommandWords /*words*/, const CommandStage& stage) {
  cursorOf(stage).pause(stage.now);
  return {};
}

Status seekMoment(CommandWords words, const CommandStage& stage) {
  TimelineCursor& cursor = cursorOf(stage);
  const auto moment = stage.model.momentNamed(fmt::format("{}", fmt::join(words, " ")));
  if (!moment.ok()) return badWord(moment.error().text());
  cursor.seek(*moment, stage.now);
  return {};
}

Status seekStart(CommandWords /*words*/, const CommandStage& stage) {
  cursorOf(stage).seek(cursorOf(stage).start(), stage.now);
  return {};
}

Status seekEnd(CommandWords /*words*/, const CommandStage& stage) {
  cursorOf(stage).seek(cursorOf(stage).end(), stage.now);
  return {};
}

Status stepSeconds(CommandWords words, const CommandStage& stage) {
  const auto seconds = numberOf(words[0]);
  if (!seconds.ok()) return seconds.error();
  constexpr double kMaxSeconds = 1e6;
  if (std::abs(*seconds) > kMaxSeconds) {
    return badWord(fmt::format("`{}` is more than {} seconds", words[0], kMaxSeconds));
  }
  cursorOf(stage).step(Nanoseconds(std::llround(*seconds * 1e9)), stage.now);
  return {};
}

Status goToEvent(CommandWords words, const CommandStage& stage) {
  const auto next = isNext(words[0]);
  if (!next.ok()) return next.error();
  TimelineCursor& cursor = cursorOf(stage);
  if (const Event* event = stage.model.eventBeside(cursor.position(stage.now), *next)) {
    cursor.seek(event->time, stage.now);
  }
  return {};
}

Status goToPacket(CommandWords words, const CommandStage& stage) {
  const auto next = isNext(words[0]);
  if (!next.ok()) return next.error();
  cursorOf(stage).pause(stage.now);
  const auto moment = stage.model.packetBeside(*next);
  if (!moment.ok()) {
    stage.model.viewer.panels.complaint = moment.error().text();
  } else if (*moment) {
    cursorOf(stage).seek(**moment, stage.now);
  }
  return {};
}

Status setPlaybackSpeed(CommandWords words, const CommandStage& stage) {
  if (cursorOf(stage).setSpeed(words[0], stage.now)) return {};
  return badWord(fmt::format("`{}` is not a speed from 0.01 to 1000", words[0]));
}

Status setLoop(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, cursorOf(stage).looping());
  if (!on.ok()) return on.error();
  cursorOf(stage).setLooping(*on);
  return {};
}

Status markMoment(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  if (words.empty()) {
    model.viewer.panels.mark.ask();
    return {};
  }
  stage.requests.mark = fmt::format("{}", fmt::join(words, " "));
  return {};
}

Status askTime(CommandWords /*words*/, const CommandStage& stage) {
  PanelState& panels = stage.model.viewer.panels;
  panels.time.ask();
  // It is typed into the time line.
  panels.shown = true;
  panels.places.openEdge("bottom");
  return {};
}

Status setClock(CommandWords words, const CommandStage& stage) {
  bool& day = stage.model.viewer.panels.wall_clock;
  if (!words.empty() && words[0] != "session" && words[0] != "day") {
    return badWord(fmt::format("`{}` is neither session nor day", words[0]));
  }
  const bool wanted = words.empty() ? !day : words[0] == "day";
  if (wanted && !hasWallClock(stage.model.origin())) {
    return badWord("this session has no time of day: it begins before the year 2000");
  }
  day = wanted;
  return {};
}

/// Two session times, or neither for `all`.
Result<std::optional<std::pair<LogTime, LogTime>>> spanOf(CommandWords words,
                                                          const CommandStage& stage) {
  using Span = std::optional<std::pair<LogTime, LogTime>>;
  if (words[0] == "all" && words.size() == 1) return Span();
  if (words.size() != 2) return badWord("it takes two times, or `all`");
  const auto from = stage.model.momentNamed(words[0]);
  if (!from.ok()) return from.error();
  const auto until = stage.model.momentNamed(words[1]);
  if (!until.ok()) return until.error();
  return Span(std::pair(*from, *until));
}

Status showSpan(CommandWords words, const CommandStage& stage) {
  const auto span = spanOf(words, stage);
  if (!span.ok()) return span.error();
  TimeView& view = stage.model.viewer.time_view;
  *span ? view.show((*span)->first, (*span)->second) : view.showAll();
  return {};
}

Status repeatSpan(CommandWords words, const CommandStage& stage) {
  TimelineCursor& cursor = cursorOf(stage);
  if (words[0] == "from" && words.size() == 1) {
    cursor.setPart(cursor.position(stage.now), cursor.partEnd(), stage.now);
    return {};
  }
  if (words[0] == "until" && words.size() == 1) {
    cursor.setPart(cursor.partStart(), cursor.position(stage.now), stage.now);
    return {};
  }
  const auto span = spanOf(words, stage);
  if (!span.ok()) return span.error();
  *span ? cursor.setPart((*span)->first, (*span)->second, stage.now) : cursor.clearPart(stage.now);
  return {};
}

Status setRepetition(CommandWords words, const CommandStage& stage) {
  constexpr std::array<std::string_view, 3> kNames{"once", "loop", "to-and-fro"};
  const auto* const found = std::ranges::find(kNames, words[0]);
  if (found == kNames.end()) {
    return badWord(fmt::format("`{}` is not once, loop or to-and-fro", words[0]));
  }
  cursorOf(stage).setRepeat(static_cast<Repeat>(found - kNames.begin()), stage.now);
  return {};
}

Status setReverse(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, cursorOf(stage).reversed());
  if (!on.ok()) return on.error();
  cursorOf(stage).setReversed(*on, stage.now);
  return {};
}

std::vector<std::string> repetitionChoices(const ViewModel& /*model*/) {
  return {"once", "loop", "to-and-fro"};
}

std::vector<std::string> speedChoices(const ViewModel& /*model*/) {
  return {"0.1", "0.25", "0.5", "1", "2", "4", "10"};
}

}  // namespace

Result<bool> isNext(const std::string& word) {
  if (word != "next" && word != "previous") {
    return badWord(fmt::format("`{}` is neither next nor previous", word));
  }
  return word == "next";
}

std::vector<Command> timeCommands() {
  std::vector<Command> commands{
      {.name = "play-pause",
       .means = "play, pause",
       .run = playPause,
       .shortcuts = {{"space", "", ""}}},
      {.name = "play", .means = "play the log", .run = playLog},
      {.name = "pause", .means = "stay at this moment", .run = pauseLog},
      {.name = "seek",
       .arguments = "T...",
       .means = "go to a session time, or to an event by its text",
       .run = seekMoment},
      {.name = "start",
       .means = "the start of the log",
       .run = seekStart,
       .shortcuts = {{"home", "", ""}},
       .repeats = true},
      {.name = "end",
       .means = "the end of the log",
       .run = seekEnd,
       .shortcuts = {{"end", "", ""}},
       .repeats = true},
      {.name = "step",
       .arguments = "SECONDS",
       .means = "forward by seconds, or back if negative",
       .run = stepSeconds,
       .shortcuts = {{"left", "-1", "a second back"},
                     {"right", "1", "a second forward"},
                     {"shift+left", "-0.1", "a tenth of a second back"},
                     {"shift+right", "0.1", "a tenth of a second forward"}},
       .repeats = true},
      {.name = "event",
       .arguments = "next|previous",
       .means = "the next or previous event",
       .run = goToEvent,
       .shortcuts = {{",", "previous", "the previous event"}, {".", "next", "the next event"}},
       .repeats = true},
      {.name = "packet",
       .arguments = "next|previous",
       .means = "the next or previous datagram",
       .run = goToPacket,
       .shortcuts = {{"shift+,", "previous", "the previous datagram"},
                     {"shift+.", "next", "the next datagram"}},
       .repeats = true},
      {.name = "speed",
       .arguments = "X",
       .means = "the speed of playing",
       .run = setPlaybackSpeed,
       .choices = speedChoices},
      {.name = "loop", .arguments = "[on|off]", .means = "begin again at the end", .run = setLoop},
      {.name = "repeat",
       .arguments = "HOW",
       .means = "once, loop or to-and-fro",
       .run = setRepetition,
       .choices = repetitionChoices},
      {.name = "part",
       .arguments = "T [T]",
       .means = "repeat from one time to another; from here, until here; all",
       .run = repeatSpan,
       .shortcuts = {{"A", "from", "repeat from here"}, {"B", "until", "repeat up to here"}}},
      {.name = "reverse",
       .arguments = "[on|off]",
       .means = "play backwards or forwards",
       .run = setReverse,
       .shortcuts = {{"J", "", ""}}},
      {.name = "show-time",
       .arguments = "T [T]",
       .means = "the time line from one time to another, or all of it",
       .run = showSpan},
      {.name = "clock",
       .arguments = "[session|day]",
       .means = "the time line in session time, or also in that of the day (UTC)",
       .run = setClock},
      {.name = "type-time",
       .means = "go to a typed time",
       .run = askTime,
       .shortcuts = {{"G", "", ""}}},
      {.name = "mark",
       .arguments = "[TEXT...]",
       .means = "a mark at this moment, beside the log",
       .run = markMoment,
       .shortcuts = {{"M", "", "a mark at this moment, with a text"}}},
  };
  for (Command& command : commands) {
    command.group = CommandGroup::time;
    command.needs_log = true;
  }
  return commands;
}

}  // namespace rocinante
