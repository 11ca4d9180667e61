#include "player/playhead/playhead_command.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

using Kind = PlayheadCommand::Kind;
using Words = std::vector<std::string_view>;

struct Word {
  std::string_view text;
  Kind kind;
  std::size_t least, most;  ///< number of arguments
  std::string_view use;
};

constexpr Word kWords[] = {
    {"play", Kind::play, 0, 0, "play"},
    {"pause", Kind::pause, 0, 0, "pause"},
    {"toggle", Kind::toggle, 0, 0, "toggle"},
    {"step", Kind::step, 0, 1, "step [N | TIME]"},
    {"back", Kind::back, 0, 1, "back [N | TIME]"},
    {"next", Kind::next, 0, 0, "next"},
    {"previous", Kind::previous, 0, 0, "previous"},
    {"seek", Kind::seek, 1, 1, "seek TIME"},
    {"speed", Kind::speed, 1, 1, "speed X"},
    {"faster", Kind::faster, 0, 0, "faster"},
    {"slower", Kind::slower, 0, 0, "slower"},
    {"loop", Kind::loop, 1, 2, "loop FROM UNTIL, or loop off"},
    {"status", Kind::status, 0, 0, "status"},
    {"quit", Kind::quit, 0, 0, "quit"},
    {"ack", Kind::ack, 1, 1, "ack N"},
};

Error bad(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

Words wordsOf(std::string_view line) {
  Words words;
  std::size_t at = 0;
  while (true) {
    at = line.find_first_not_of(" \t", at);
    if (at == line.npos) return words;
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
}

std::optional<std::uint64_t> wholeNumber(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// The argument of `step` and `back`: a number of messages, or a time with a unit.
Status readSteps(std::string_view text, PlayheadCommand& command) {
  if (const auto count = wholeNumber(text)) {
    if (*count == 0 || *count > kMaxSteps) {
      return bad("a step is 1 to " + std::to_string(kMaxSteps) + " messages");
    }
    command.count = *count;
    return {};
  }
  const bool has_unit = !text.empty() && text.back() == 's';
  const Result<Nanoseconds> duration = parseDuration(text);
  if (!has_unit || !duration || duration->count() < 0) {
    return bad("a step is a number of messages, or a time with its unit such as 0.5s");
  }
  command.duration = command.kind == Kind::back ? -*duration : *duration;
  command.kind = Kind::move;
  return {};
}

Status readTime(std::string_view text, LogTime origin, LogTime end, LogTime& time) {
  const Result<LogTime> parsed = parseSessionTime(text, origin, end);
  if (!parsed) return bad(parsed.error().what);
  time = *parsed;
  return {};
}

}  // namespace

Result<PlayheadCommand> parsePlayheadCommand(std::string_view line, LogTime origin, LogTime end) {
  if (line.size() > kMaxCommandBytes) {
    return bad("a command has at most " + std::to_string(kMaxCommandBytes) + " bytes");
  }
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  Words words = wordsOf(line);
  if (words.empty()) return bad("the command is empty");
  const auto* const word = std::find_if(std::begin(kWords), std::end(kWords),
                                        [&](const Word& each) { return each.text == words[0]; });
  if (word == std::end(kWords)) {
    return bad("unknown command " + plainText(std::string(words[0].substr(0, 40))));
  }
  PlayheadCommand command;
  command.kind = word->kind;
  words.erase(words.begin());
  const bool is_off = command.kind == Kind::loop && words.size() == 1 && words[0] == "off";
  if (is_off) {
    command.kind = Kind::loop_off;
    return command;
  }
  const std::size_t least = command.kind == Kind::loop ? 2 : word->least;
  if (words.size() < least || words.size() > word->most) {
    return bad("usage: " + std::string(word->use));
  }
  Status read;
  switch (command.kind) {
    case Kind::step:
    case Kind::back:
      if (!words.empty()) read = readSteps(words[0], command);
      break;
    case Kind::seek:
      read = readTime(words[0], origin, end, command.from);
      break;
    case Kind::loop:
      read = readTime(words[0], origin, end, command.from);
      if (read) read = readTime(words[1], origin, end, command.until);
      if (read && command.from >= command.until) read = bad("a loop must end after it begins");
      break;
    case Kind::speed: {
      const Result<PlaybackSpeed> speed = PlaybackSpeed::parse(words[0]);
      if (!speed) return bad(speed.error().what);
      command.speed = *speed;
      break;
    }
    case Kind::ack: {
      const auto count = wholeNumber(words[0]);
      if (!count) return bad("usage: ack N");
      command.count = *count;
      break;
    }
    default:
      break;
  }
  if (!read) return read.error();
  return command;
}

}  // namespace rocinante
