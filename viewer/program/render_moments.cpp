#include "viewer/program/render_moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <numeric>

#include "core/base/atomic_file.h"
#include "core/base/duration_text.h"
#include "core/base/pattern.h"
#include "core/session/moment_name.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFrames = 1'000'000;
constexpr std::int64_t kSecondNs = 1'000'000'000;
constexpr std::uint64_t kMaxTimesFileBytes = std::uint64_t{64} << 20U;

Error badMoment(std::string what, std::string where = {}) {
  return {ErrorKind::bad_argument, std::move(what), std::move(where)};
}

struct LogPart {
  LogTime from, until;  // until exclusive
};

/// The requested range of the log.
Result<LogPart> spanOf(const MomentChoice& choice, const Timeline& session) {
  LogPart span{session.start(), session.end() + Nanoseconds(1)};
  if (!choice.from.empty()) {
    const auto from = parseSessionTime(choice.from, session.origin(), session.end());
    if (!from) return from.error();
    span.from = std::max(span.from, *from);
  }
  if (!choice.until.empty()) {
    const auto until = parseSessionTime(choice.until, session.origin(), session.end());
    if (!until) return until.error();
    span.until = std::min(span.until, *until);
  }
  return span;
}

/// A time, or every event of that name, as `events` has them.
Status addMoment(const std::string& text, Timeline& session, const std::string& where,
                 std::vector<RenderMoment>& moments, StateDamage& hiding) {
  const auto time = parseSessionTime(text, session.origin(), session.end());
  if (!time) {
    const auto events = isSessionTime(text) ? Result<std::vector<Event>>(time.error())
                                            : eventsNamed(text, session, hiding);
    if (!events) {
      return badMoment(
          isSessionTime(text) ? time.error().what : time.error().what + "; " + events.error().what,
          where.empty() ? time.error().where : where);
    }
    for (const Event& event : *events) {
      // A mark may be outside the captured range.
      if (event.time < session.start() || event.time > session.end()) continue;
      moments.push_back({secondsText(event.time - session.origin(), 3), event.time, event.text});
    }
    return {};
  }
  if (*time < session.start() || *time > session.end()) {
    const auto shown = [&](LogTime moment) { return secondsText(moment - session.origin(), 3); };
    return badMoment(fmt::format("{} is outside the log, which has {} to {} s", text,
                                 shown(session.start()), shown(session.end())),
                     where.empty() ? session.log().name() : where);
  }
  moments.push_back({text, *time, {}});
  return {};
}

Status addTimesOfFile(const std::filesystem::path& file, Timeline& session,
                      std::vector<RenderMoment>& moments, StateDamage& hiding) {
  const auto content = readFile(file, kMaxTimesFileBytes);
  if (!content) return content.error();
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < content->size();) {
    const std::size_t end = std::min(content->find('\n', begin), content->size());
    std::string line = content->substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    line.resize(std::min(line.find('#'), line.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    line = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
    const std::string where = fmt::format("{}, line {}", file.string(), line_number);
    if (Status added = addMoment(line, session, where, moments, hiding); !added) return added;
    if (moments.size() > kMaxFrames) break;
  }
  return {};
}

/// Adds moments `offset(i)` from the origin within the range, i up to `most`; `offset` must not
/// decrease.
void addGrid(const std::function<Nanoseconds(std::int64_t)>& offset, const LogPart& span,
             LogTime origin, std::int64_t most, std::vector<RenderMoment>& moments) {
  // The first one not before the range; not before the origin.
  std::int64_t low = 0;
  for (std::int64_t high = most; low < high;) {
    const std::int64_t middle = low + (high - low) / 2;
    if (origin + offset(middle) < span.from) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  for (std::int64_t i = low; i <= most && moments.size() <= kMaxFrames; ++i) {
    const LogTime time = origin + offset(i);
    if (time >= span.until) return;
    if (time >= span.from) moments.push_back({secondsText(offset(i), 3), time, {}});
  }
}

Status addEvents(const MomentChoice& choice, const LogPart& span, Timeline& session,
                 std::vector<RenderMoment>& moments, StateDamage& hiding) {
  StateDamage damage;
  const auto events = session.events(&damage);
  if (!events) return events.error();
  damage = damage.within(span.from - session.origin(), span.until - session.origin());
  hiding.add(damage);
  for (const Event& event : **events) {
    const bool wanted =
        choice.all_events ||
        std::any_of(choice.events.begin(), choice.events.end(), [&](const std::string& pattern) {
          return patternMatches(pattern, event.text);
        });
    // A mark may be outside the captured range.
    if (!wanted || event.time < span.from || event.time >= span.until) continue;
    moments.push_back({secondsText(event.time - session.origin(), 3), event.time, event.text});
  }
  if (moments.empty()) {
    const std::string none =
        choice.all_events ? "the log has no event in this range" : "no event matches";
    if (damage.empty()) return badMoment(none, session.log().name());
    return badMoment(none + "; " + damage.what(), damage.where());
  }
  return {};
}

}  // namespace

std::string FrameRate::text() const {
  return seconds == 1 ? std::to_string(count) : fmt::format("{}/{}", count, seconds);
}

Result<FrameRate> parseFrameRate(const std::string& text) {
  const auto whole = [](std::string_view digits) {
    std::int64_t value = -1;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return fault == std::errc() && end == digits.data() + digits.size() ? value : -1;
  };
  const std::string_view view(text);
  const std::size_t slash = view.find('/'), dot = view.find('.');
  FrameRate rate{-1, 1};
  if (slash != std::string_view::npos) {
    rate = {whole(view.substr(0, slash)), whole(view.substr(slash + 1))};
  } else if (dot != std::string_view::npos && view.size() - dot - 1 <= 4) {
    for (std::size_t i = dot + 1; i < view.size(); ++i) rate.seconds *= 10;
    rate.count = whole(text.substr(0, dot) + text.substr(dot + 1));
  } else {
    rate.count = whole(view);
  }
  constexpr std::int64_t kMax = 1'000'000;
  if (rate.count < 1 || rate.seconds < 1 || rate.count > kMax * 10 || rate.seconds > kMax ||
      rate.count > 1000 * rate.seconds) {
    return badMoment("`" + text +
                     "` is not a frame rate: use 25, 29.97 or 30000/1001, at most 1000");
  }
  const std::int64_t common = std::gcd(rate.count, rate.seconds);
  return FrameRate{rate.count / common, rate.seconds / common};
}

Result<std::vector<RenderMoment>> renderMoments(const MomentChoice& choice, Timeline& session,
                                                StateDamage& hiding) {
  const auto span = spanOf(choice, session);
  if (!span) return span.error();
  std::vector<RenderMoment> moments;
  for (const std::string& text : choice.at) {
    if (Status added = addMoment(text, session, {}, moments, hiding); !added) return added.error();
  }
  if (!choice.at_file.empty()) {
    if (Status added = addTimesOfFile(choice.at_file, session, moments, hiding); !added) {
      return added.error();
    }
  }
  constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::max() / 4;
  if (!choice.every.empty()) {
    const auto step = parseDuration(choice.every);
    if (!step) return step.error();
    if (step->count() <= 0) return badMoment("--every needs a duration greater than zero");
    // Count from the origin, not from the start, so that cutting a log does not shift the moments.
    addGrid([&](std::int64_t i) { return *step * i; }, *span, session.origin(),
            kLongest / step->count(), moments);
  }
  if (!choice.rate.empty()) {
    const auto rate = parseFrameRate(choice.rate);
    if (!rate) return rate.error();
    const auto offset = [&](std::int64_t i) {
      const std::int64_t product = i * rate->seconds;
      return Nanoseconds(product / rate->count * kSecondNs +
                         product % rate->count * kSecondNs / rate->count);
    };
    addGrid(offset, *span, session.origin(), kLongest / kSecondNs / rate->seconds, moments);
  }
  if (choice.all_events || !choice.events.empty()) {
    if (Status added = addEvents(choice, *span, session, moments, hiding); !added) {
      return added.error();
    }
  }
  if (moments.empty()) return badMoment("no moment is in the log");
  if (moments.size() > kMaxFrames) {
    return badMoment(fmt::format("more than {} frames", kMaxFrames));
  }
  return moments;
}

}  // namespace rocinante
