#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <tuple>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/cli/help_formatter.h"
#include "core/cli/opened_session.h"
#include "core/cli/search_options.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/report/json_text.h"
#include "golden/command/commands.h"
#include "golden/command/suite_arguments.h"
#include "golden/session/bisect.h"
#include "golden/store/child_output.h"
#include "golden/why/state_change.h"
#include "viewer/picture/picture_options.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxChanges = 8;

/// Shared, because the returned closures keep it alive.
Result<std::shared_ptr<FrameMaker>> makerOf(const std::filesystem::path& cell,
                                            const std::filesystem::path& log,
                                            const CellOptions& options) {
  auto loaded = loadCellOrLog(cell, options);
  if (!loaded.ok()) return loaded.error();
  auto session = Timeline::open(log);
  if (!session.ok()) return session.error();
  auto opened = FrameMaker::open(std::move(*loaded), std::move(*session), Profile::reproducible);
  if (!opened.ok()) return opened.error();
  return std::make_shared<FrameMaker>(std::move(*opened));
}

DrawnHash drawnByUs(std::shared_ptr<FrameMaker> maker, const FrameRequest& asked) {
  return [maker = std::move(maker), asked](Nanoseconds moment) -> Result<std::string> {
    FrameRequest request = asked;
    request.time = maker->session()->origin() + moment;
    const auto frame = maker->frame(request);
    if (!frame.ok()) return frame.error();
    return pictureSha256(*frame);
  };
}

/// The first run of 64 hexadecimal digits in a program's output.
std::string hashIn(const std::string& text) {
  std::size_t digits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = (text[i] >= '0' && text[i] <= '9') || (text[i] >= 'a' && text[i] <= 'f');
    digits = is_digit ? digits + 1 : 0;
    if (digits == 64) return text.substr(i - 63, 64);
  }
  return {};
}

/// Another build of rocinante-render.
DrawnHash drawnBy(const std::string& program, const std::filesystem::path& cell,
                  const std::filesystem::path& log, const FrameRequest& asked,
                  const ModelSearch& where) {
  return [=](Nanoseconds moment) -> Result<std::string> {
    std::vector<std::string> words = {program, cell.string(),          log.string(),
                                      "--at",  secondsText(moment, 9), "--hash"};
    if (!asked.camera.empty()) words.insert(words.end(), {"--camera", asked.camera});
    for (const auto& more : {pictureWords(asked), cli::searchWords(where)}) {
      words.insert(words.end(), more.begin(), more.end());
    }
    const auto ran = childOutput(words);
    if (!ran.ok()) return ran.error();
    if (ran->exit_code != 0) {
      return Error{ErrorKind::unreadable,
                   fmt::format("it ended with exit code {}: {}", ran->exit_code,
                               plainText(ran->err.substr(0, ran->err.find('\n')))),
                   program};
    }
    std::string hash = hashIn(ran->out);
    if (hash.empty()) return Error{ErrorKind::unsupported, "it printed no --hash", program};
    return hash;
  };
}

Result<std::vector<Nanoseconds>> momentsOfBoth(const BisectArguments& arguments) {
  auto moments = changesOf(arguments.log);
  if (!moments.ok() || arguments.other_log.empty()) return moments;
  const auto others = changesOf(arguments.other_log);
  if (!others.ok()) return others.error();
  if (moments->empty() || others->empty()) {
    return Error{ErrorKind::not_found, "the log has no messages, so there is nothing to draw",
                 moments->empty() ? arguments.log.string() : arguments.other_log};
  }
  // Only times within both logs.
  const Nanoseconds from = std::max(moments->front(), others->front());
  const Nanoseconds until = std::min(moments->back(), others->back());
  std::vector<Nanoseconds> both;
  std::ranges::set_union(*moments, *others, std::back_inserter(both));
  std::erase_if(both, [&](Nanoseconds moment) { return moment < from || moment > until; });
  return both;
}

Status limitMoments(const BisectArguments& arguments, const Timeline& session,
                    std::vector<Nanoseconds>& moments) {
  if (!arguments.from.empty()) {
    const auto from = parseSessionTime(arguments.from, session.origin(), session.end());
    if (!from.ok()) return from.error();
    std::erase_if(moments, [&](Nanoseconds moment) { return session.origin() + moment < *from; });
  }
  if (!arguments.until.empty()) {
    const auto until = parseSessionTime(arguments.until, session.origin(), session.end());
    if (!until.ok()) return until.error();
    std::erase_if(moments, [&](Nanoseconds moment) { return session.origin() + moment >= *until; });
  }
  if (!moments.empty()) return {};
  return Error{ErrorKind::not_found, "no moment to draw between --from and --until",
               arguments.log.string()};
}

struct BisectSpan {
  Nanoseconds from, until;  // since the origin
};

/// The searched range: the time covered by both logs, within --from and --until. The moments may
/// begin later and end earlier, where no message could be read.
Result<BisectSpan> bisectSpan(const BisectArguments& arguments, const Timeline& session,
                              const Timeline* other, const std::vector<Nanoseconds>& moments) {
  BisectSpan span{session.start() - session.origin(), session.end() - session.origin()};
  if (other != nullptr) {
    span.from = std::max(span.from, other->start() - other->origin());
    span.until = std::min(span.until, other->end() - other->origin());
  }
  if (!arguments.from.empty()) span.from = moments.front();
  if (arguments.until.empty()) return span;
  const auto until = parseSessionTime(arguments.until, session.origin(), session.end());
  if (!until.ok()) return until.error();
  span.until = std::max(moments.back(), std::min(span.until, *until - session.origin()));
  return span;
}

/// Refuses damaged ranges: missing messages may hide the first difference.
Status checkWhole(Timeline& session, const BisectSpan& span) {
  StateDamage damage;
  const LogTime origin = session.origin();
  Status read = session.addDamage(origin + span.from, origin + span.until, damage);
  if (!read || damage.empty()) return read;
  return Error{ErrorKind::damaged, "incomparable: " + damage.what(), damage.where()};
}

/// Differences of the two sessions at the first different picture: joints by name, bases, drawings,
/// cameras. Empty when only the build differs.
Result<std::vector<StateChange>> partingItems(const BisectArguments& arguments, Nanoseconds at) {
  const std::filesystem::path log =
      arguments.other_log.empty() ? arguments.log : std::filesystem::path(arguments.other_log);
  const std::filesystem::path cell = arguments.cell.empty() ? arguments.log : arguments.cell;
  CellOptions options;
  static_cast<ModelSearch&>(options) = arguments;
  options.geometry = false;
  const auto a_cell = loadCellOrLog(cell, options);
  if (!a_cell.ok()) return a_cell.error();
  const std::filesystem::path other_cell =
      arguments.other_cell.empty() ? cell : std::filesystem::path(arguments.other_cell);
  const auto b_cell = loadCellOrLog(other_cell, options);
  if (!b_cell.ok()) return b_cell.error();
  auto a = Timeline::open(arguments.log);
  if (!a.ok()) return a.error();
  auto b = Timeline::open(log);
  if (!b.ok()) return b.error();
  const auto a_state = a->stateAt(a->origin() + at);
  if (!a_state.ok()) return a_state.error();
  const auto b_state = b->stateAt(b->origin() + at);
  if (!b_state.ok()) return b_state.error();
  return stateChanges({*a_cell, **a_state}, {*b_cell, **b_state}, arguments.camera);
}

std::string answerText(const BisectAnswer& answer, const std::vector<StateChange>& changes) {
  const auto seconds = [](Nanoseconds moment) { return secondsText(moment, 3) + " s"; };
  std::string text;
  if (!answer.first) {
    if (answer.frames == 0) {
      return fmt::format("no difference: the states are equal at all of {}\n",
                         countText(answer.moments, "moment"));
    }
    return fmt::format("no difference: {} of {} drawn, with the same pictures\n", answer.frames,
                       countText(answer.moments, "moment"));
  }
  text = fmt::format("the pictures first differ at {}\n", seconds(*answer.first));
  if (answer.last_alike) {
    text += fmt::format("they are the same at {}, the last moment drawn before it\n",
                        seconds(*answer.last_alike));
  }
  text += answer.is_first_since_probe
              ? fmt::format("every moment since {} was compared\n", seconds(answer.searched_from))
              : "found by bisection; an earlier difference is possible\n";
  text += fmt::format("{} of {} drawn\n", answer.frames, countText(answer.moments, "moment"));
  if (changes.empty()) return text;
  text += "differences there:\n";
  for (std::size_t i = 0; i < std::min(changes.size(), kMaxChanges); ++i) {
    text += "  " + plainText(changes[i].text) + "\n";
  }
  if (changes.size() > kMaxChanges) {
    text += fmt::format("  and {} more\n", changes.size() - kMaxChanges);
  }
  return text;
}

std::string answerJson(const BisectAnswer& answer, const std::vector<StateChange>& changes) {
  const auto countOrNull = [](const std::optional<Nanoseconds>& moment) {
    return moment ? Json(moment->count()) : Json(nullptr);
  };
  Json parted = Json::array();
  for (const StateChange& change : changes) {
    parted.push_back({{"item", change.item}, {"text", change.text}});
    // Radians or metres.
    if (change.amount) parted.back()["amount"] = *change.amount;
  }
  const Json root = {
      {"format", 1},
      {"verdict", answer.first ? "different" : "same"},
      {"first_ns", countOrNull(answer.first)},
      {"last_alike_ns", countOrNull(answer.last_alike)},
      {"every_moment_since_ns",
       answer.is_first_since_probe ? countOrNull(answer.searched_from) : countOrNull(std::nullopt)},
      {"drawn", answer.frames},
      {"moments", answer.moments},
      {"changes", parted}};
  return jsonText(root);
}

Result<BisectQuestion> bisectQuestion(const BisectArguments& arguments) {
  const std::filesystem::path cell = arguments.cell.empty() ? arguments.log : arguments.cell;
  const std::filesystem::path other_log =
      arguments.other_log.empty() ? arguments.log : std::filesystem::path(arguments.other_log);
  const std::filesystem::path other_cell =
      arguments.other_cell.empty() ? cell : std::filesystem::path(arguments.other_cell);
  CellOptions options;
  static_cast<ModelSearch&>(options) = arguments;
  FrameRequest request;
  request.camera = arguments.camera;
  request.samples = arguments.samples;
  const auto size = parsePictureSize(arguments.size);
  if (!size.ok()) return size.error();
  std::tie(request.width, request.height) = *size;
  BisectQuestion question;
  question.most_frames = arguments.most_frames;
  auto moments = momentsOfBoth(arguments);
  if (!moments.ok()) return moments.error();
  question.moments = std::move(*moments);
  auto session = Timeline::open(arguments.log);
  if (!session.ok()) return session.error();
  if (auto limited = limitMoments(arguments, *session, question.moments); !limited) {
    return limited.error();
  }
  question.alike_before = question.moments.front();
  std::optional<Timeline> other;
  if (!arguments.other_log.empty()) {
    auto opened = Timeline::open(other_log);
    if (!opened.ok()) return opened.error();
    other = std::move(*opened);
  }
  const auto span = bisectSpan(arguments, *session, other ? &*other : nullptr, question.moments);
  if (!span.ok()) return span.error();
  if (Status whole = checkWhole(*session, *span); !whole) return whole.error();
  if (other) {
    if (Status whole = checkWhole(*other, *span); !whole) return whole.error();
  }
  // Events only choose where to look first.
  StateDamage hiding;
  const auto events = session->events(&hiding);
  if (!events.ok()) return events.error();
  for (const Event& event : **events) question.probes.push_back(event.time - session->origin());
  // Evenly spaced probes too, for sessions without events.
  for (std::size_t i = 1; i < 16; ++i) {
    question.probes.push_back(question.moments[question.moments.size() * i / 16]);
  }
  // With one cell and one build, equal states give equal pictures and need not be drawn.
  if (other && arguments.other_cell.empty() && arguments.other_render.empty()) {
    const auto part = statesPart(*session, *other, question.moments);
    if (!part.ok()) return part.error();
    question.alike_before = *part ? **part : question.moments.back() + Nanoseconds(1);
  }
  auto a = makerOf(cell, arguments.log, options);
  if (!a.ok()) return a.error();
  question.a = drawnByUs(*a, request);
  if (!arguments.other_render.empty()) {
    question.b = drawnBy(arguments.other_render, other_cell, other_log, request, arguments);
    return question;
  }
  auto b = makerOf(other_cell, other_log, options);
  if (!b.ok()) return b.error();
  // `question.a` owns *a.
  (*b)->fitLike(**a);
  question.b = drawnByUs(std::move(*b), request);
  return question;
}

}  // namespace

cli::CommandLine addBisectCommand(cli::CommandLine app, BisectArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand(
      "bisect", "find the first time at which two logs, cells or builds draw different pictures");
  command.addOption("CELL", arguments.cell, "the cell; default: the one that LOG carries");
  command.addOption("LOG", arguments.log, "the session").showRequired();
  command.addOption("--other-log", arguments.other_log, "compare with this log");
  command.addOption("--other-cell", arguments.other_cell, "compare with this cell");
  command.addOption("--other-render", arguments.other_render,
                    "compare with this rocinante-render of another build");
  command.addOption("--camera", arguments.camera, "a camera of the cell; default: its first");
  command.addOption("--size", arguments.size, "picture size").showDefault();
  command.addOption("--samples", arguments.samples, "multisampling: 1 or 4").showDefault();
  command.addOption("--from", arguments.from, "start at this session time");
  command.addOption("--until", arguments.until, "end before this session time");
  command
      .addOption("--most-frames", arguments.most_frames,
                 "compare up to this many moments one by one; bisect longer ranges")
      .showDefault();
  cli::addSearchOptions(command, arguments);
  command.addFlag("--json", arguments.json, "answer as JSON");
  return command;
}

Result<cli::Exit> runBisectCommand(const BisectArguments& given) {
  BisectArguments arguments = given;
  if (Status has = orderLogAndItsCell(arguments.cell, arguments.log); !has) return has.error();
  if (arguments.other_log.empty() && arguments.other_cell.empty() &&
      arguments.other_render.empty()) {
    return Error{ErrorKind::bad_argument,
                 "one of --other-log, --other-cell and --other-render is required", ""};
  }
  const auto log = cli::openSession(arguments.log, arguments.cell, arguments);
  if (!log.ok()) return log.error();
  const bool is_alone = arguments.cell.empty();
  if (is_alone) arguments.cell = log->log;
  arguments.log = log->log;
  OpenedRecording other;
  if (!arguments.other_log.empty()) {
    auto opened = cli::openSession(arguments.other_log, arguments.cell, arguments);
    if (!opened.ok()) return opened.error();
    other = std::move(*opened);
    arguments.other_log = other.log.string();
  }
  // The meshes of its own robot were looked for when it was imported.
  if (is_alone && log->imported) static_cast<ModelSearch&>(arguments) = {};
  const auto question = bisectQuestion(arguments);
  if (!question.ok()) return other.named(log->named(question.error()));
  cli::warnOfAccount(arguments.log, nullptr);
  if (!arguments.other_log.empty()) cli::warnOfAccount(arguments.other_log, nullptr);
  const auto answer = bisectPictures(*question);
  if (!answer.ok()) return answer.error();
  std::vector<StateChange> changes;
  if (answer->first) {
    auto found = partingItems(arguments, *answer->first);
    if (!found.ok()) return found.error();
    changes = std::move(*found);
  }
  std::cout << (arguments.json ? answerJson(*answer, changes) : answerText(*answer, changes));
  return answer->first ? cli::Exit::no : cli::Exit::done;
}

}  // namespace rocinante
