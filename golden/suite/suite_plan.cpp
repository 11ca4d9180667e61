#include "golden/suite/suite_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <numeric>
#include <set>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/pattern.h"
#include "core/base/plain_text.h"
#include "core/session/moment_name.h"
#include "golden/suite/suite_case.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFramesPerCase = 100'000;

std::string momentName(Nanoseconds since_origin) {
  const std::int64_t ms = since_origin.count() / 1'000'000;
  return fmt::format("{:05}.{:03}s", ms / 1000, ms % 1000);
}

/// A moment of a case: the suffix of the frame's name, and the time.
struct NamedMoment {
  std::string suffix;
  std::optional<LogTime> time{};
  std::string why{};
};

/// Damage that may hide events which would change the count: before the event, or after it when
/// counting from the end.
StateDamage hidingOne(const StateDamage& hiding, const CaseMoment& moment, Nanoseconds event) {
  return moment.occurrence > 0 ? hiding.within(Nanoseconds::min(), event)
                               : hiding.within(event, Nanoseconds::max());
}

Result<std::vector<NamedMoment>> momentsAtEvent(const CaseMoment& moment, Timeline& session) {
  StateDamage hiding;
  const auto events = session.events(&hiding);
  if (!events) return events.error();
  const std::string or_hidden = hiding.empty() ? "" : "; " + hiding.text();
  std::vector<LogTime> times;
  for (const Event& event : **events) {
    if (event.text == *moment.event) times.push_back(event.time);
  }
  const auto count = static_cast<int>(std::min<std::size_t>(times.size(), 1U << 30U));
  const int place = moment.occurrence > 0 ? moment.occurrence - 1 : count + moment.occurrence;
  if (count == 0) {
    return std::vector<NamedMoment>{
        {"", {}, fmt::format("the log has no event \"{}\"", plainText(*moment.event)) + or_hidden}};
  }
  if (place < 0 || place >= count) {
    return std::vector<NamedMoment>{
        {"",
         {},
         fmt::format("the log has event \"{}\" {} times; `occurrence` "
                     "asks for {}",
                     plainText(*moment.event), count, moment.occurrence) +
             or_hidden}};
  }
  const LogTime event = times[static_cast<std::size_t>(place)];
  const StateDamage before = hidingOne(hiding, moment, event - session.origin());
  if (!before.empty()) {
    return std::vector<NamedMoment>{{"",
                                     {},
                                     fmt::format("another event \"{}\" may be missing: {}",
                                                 plainText(*moment.event), before.text())}};
  }
  return std::vector<NamedMoment>{{"", event + moment.after}};
}

Result<std::vector<NamedMoment>> momentsAtEvents(const CaseMoment& moment, Timeline& session) {
  StateDamage hiding;
  const auto events = session.events(&hiding);
  if (!events) return events.error();
  std::vector<NamedMoment> moments;
  std::map<std::string, int> seen;
  for (const Event& event : **events) {
    if (!patternMatches(*moment.events, event.text)) continue;
    if (moments.size() == kMaxFramesPerCase) break;
    // Named by text and occurrence, not by time, so that a new recording has the same names.
    const std::string word = fileWord(event.text);
    const int turn = ++seen[word];
    moments.push_back(
        {turn == 1 ? "-" + word : fmt::format("-{}.{}", word, turn), event.time + moment.after});
  }
  if (moments.empty()) {
    moments.push_back(
        {"", {}, fmt::format("no event of the log matches \"{}\"", plainText(*moment.events))});
  }
  // A hidden event would also change the numbers of the others.
  if (!hiding.empty()) {
    for (NamedMoment& each : moments) {
      each.time.reset();
      each.why = (each.why.empty() ? "an event may be missing" : each.why) + ": " + hiding.text();
    }
  }
  return moments;
}

Result<std::vector<NamedMoment>> momentsOf(const SuiteCase& made, Timeline* session) {
  const CaseMoment& moment = made.moment;
  const bool has_time = moment.at || moment.event || moment.events || moment.every;
  if (session == nullptr) {
    if (!has_time) return std::vector<NamedMoment>{{"", LogTime{}}};
    return std::vector<NamedMoment>{{"", {}, "the case has a moment, but the suite has no log"}};
  }
  if (moment.event) return momentsAtEvent(moment, *session);
  if (moment.events) return momentsAtEvents(moment, *session);
  if (moment.every) {
    std::vector<NamedMoment> moments;
    for (LogTime time = session->origin();
         time <= session->end() && moments.size() < kMaxFramesPerCase; time += *moment.every) {
      moments.push_back({"-" + momentName(time - session->origin()), time});
    }
    return moments;
  }
  if (!moment.at) {
    return std::vector<NamedMoment>{
        {"", {}, "a case over a log needs one of `at`, `event`, `events` and `every`"}};
  }
  if (!isSessionTime(*moment.at)) {
    // The name of an event: as `event` has it.
    CaseMoment named = moment;
    named.event = moment.at;
    return momentsAtEvent(named, *session);
  }
  const auto time = parseSessionTime(*moment.at, session->origin(), session->end());
  if (!time.ok()) return time.error();
  return std::vector<NamedMoment>{{"", *time}};
}

/// A moment outside the log does not exist, so the frame cannot pass unjudged.
void refuseMomentOutside(const Timeline& session, SuiteFrame& frame) {
  if (!frame.time || (*frame.time >= session.start() && *frame.time <= session.end())) return;
  frame.why = fmt::format("its moment is outside the log: {} s of {} s",
                          secondsText(*frame.time - session.origin(), 3),
                          secondsText(session.end() - session.origin(), 3));
  frame.time.reset();
}

bool anyGlobMatches(const std::vector<std::string>& globs, const SuiteFrame& frame) {
  return std::ranges::any_of(globs, [&](const std::string& glob) {
    return patternMatches(glob, frame.name) || patternMatches(glob, frame.case_name);
  });
}

bool hasAnyTag(const SuiteFrame& frame, const std::vector<std::string>& tags) {
  return std::ranges::any_of(tags, [&](const std::string& tag) {
    return std::ranges::find(frame.tags, tag) != frame.tags.end();
  });
}

}  // namespace

std::string fileWord(std::string_view text) {
  std::string word;
  for (const char c : text.substr(0, 40)) word += isFileText({&c, 1}) ? c : '_';
  return word;
}

Result<std::pair<int, int>> parseShard(std::string_view text) {
  int shard = 0;
  int shards = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shards);
    if (second.ec == std::errc() && second.ptr == end && shard >= 1 && shard <= shards &&
        shards <= kMaxShards) {
      return std::pair(shard, shards);
    }
  }
  return Error{ErrorKind::bad_argument, "a shard must be I/N, from 1/N to N/N", std::string(text)};
}

Result<std::vector<SuiteFrame>> planFrames(const Suite& suite, Timeline* session) {
  std::vector<SuiteFrame> frames;
  std::map<std::string, int> lines;
  for (const SuiteCase& made : suite.cases) {
    const std::string place = fmt::format("{}:{}", suite.file.string(), made.line);
    const auto moments = momentsOf(made, session);
    if (!moments.ok()) {
      return Error{moments.error().kind, moments.error().what, place + ", case " + made.name};
    }
    const bool several = made.cameras.size() > 1;
    const std::vector<std::string> cameras =
        made.cameras.empty() ? std::vector<std::string>{""} : made.cameras;
    for (const NamedMoment& moment : *moments) {
      for (const std::string& camera : cameras) {
        SuiteFrame frame{made.name + (several ? "." + fileWord(camera) : "") + moment.suffix, &made,
                         moment.time, moment.why};
        frame.case_name = made.name;
        frame.camera = camera;
        frame.tags = made.tags;
        frame.place = frames.size();
        frame.line = made.line;
        if (session != nullptr) refuseMomentOutside(*session, frame);
        const auto [other, is_new] = lines.emplace(frame.name, made.line);
        if (!is_new) {
          return Error{ErrorKind::bad_argument,
                       fmt::format("two frames would be named `{}`; the other comes from line {}",
                                   frame.name, other->second),
                       place};
        }
        frames.push_back(std::move(frame));
      }
    }
  }
  return frames;
}

Result<std::vector<SuiteFrame>> selectFrames(std::vector<SuiteFrame> frames,
                                             const FrameSelection& selection, const Suite& suite) {
  std::erase_if(frames, [&](const SuiteFrame& frame) {
    return (!selection.only.empty() && !anyGlobMatches(selection.only, frame)) ||
           (!selection.tags.empty() && !hasAnyTag(frame, selection.tags)) ||
           hasAnyTag(frame, selection.not_tags);
  });
  if (frames.empty()) {
    return Error{ErrorKind::bad_argument, "no case is selected, so nothing would be judged",
                 suite.file.string()};
  }
  if (selection.shards == 1) return frames;
  // Deal out whole cases in turn: frames of one case stay together, and a shard's content depends
  // only on the suite.
  std::map<const SuiteCase*, int> turns;
  for (const SuiteFrame& frame : frames) {
    turns.emplace(frame.suite_case, static_cast<int>(turns.size()));
  }
  std::erase_if(frames, [&](const SuiteFrame& frame) {
    return turns[frame.suite_case] % selection.shards != selection.shard - 1;
  });
  if (frames.empty()) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("shard {}/{} is empty: with {}, ask for at most {}", selection.shard,
                             selection.shards, countText(turns.size(), "case"),
                             countText(turns.size(), "shard")),
                 suite.file.string()};
  }
  return frames;
}

std::vector<const SuiteRun*> selectRuns(const Suite& suite, const std::vector<SuiteFrame>& frames,
                                        const FrameSelection& selection) {
  const auto hasAny = [](const SuiteRun& run, const std::vector<std::string>& tags) {
    return std::ranges::any_of(tags, [&](const std::string& tag) {
      return std::ranges::find(run.tags, tag) != run.tags.end();
    });
  };
  std::set<const SuiteCase*> cases;
  FrameSelection of_all = selection;
  of_all.shard = of_all.shards = 1;
  if (const auto selected = selectFrames(frames, of_all, suite); selected.ok()) {
    for (const SuiteFrame& frame : *selected) cases.insert(frame.suite_case);
  }
  std::vector<const SuiteRun*> runs;
  std::size_t turn = cases.size();
  for (const SuiteRun& run : suite.runs) {
    if (!selection.only.empty() && !anyPatternMatches(selection.only, run.name)) continue;
    if (!selection.tags.empty() && !hasAny(run, selection.tags)) continue;
    if (hasAny(run, selection.not_tags)) continue;
    const auto its = static_cast<int>(turn++ % static_cast<std::size_t>(selection.shards));
    if (its == selection.shard - 1) runs.push_back(&run);
  }
  return runs;
}

std::vector<std::size_t> inLogOrder(const std::vector<SuiteFrame>& frames) {
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return frames[i].time; });
  return order;
}

}  // namespace rocinante
