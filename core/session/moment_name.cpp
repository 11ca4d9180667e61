#include "core/session/moment_name.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/base/plain_text.h"

namespace rocinante {

Result<std::vector<Event>> eventsNamed(std::string_view pattern, Timeline& session,
                                       StateDamage& hiding) {
  StateDamage damage;
  const auto events = session.events(&damage);
  if (!events) return events.error();
  hiding.add(damage);
  std::vector<Event> named;
  std::vector<std::string_view> texts;
  for (const Event& event : **events) {
    if (patternMatches(pattern, event.text)) named.push_back(event);
    texts.push_back(event.text);
  }
  if (!named.empty()) return named;
  const std::string meant = didYouMean(pattern, texts);
  std::string what = fmt::format("no event of the log is named `{}`", plainText(pattern));
  if (!meant.empty()) what += ": " + meant;
  if (damage.empty()) return Error{ErrorKind::not_found, what, session.log().name()};
  return Error{ErrorKind::damaged, what + "; " + damage.what(), damage.where()};
}

Result<LogTime> momentOfEvent(std::string_view pattern, Timeline& session) {
  StateDamage hiding;
  const auto named = eventsNamed(pattern, session, hiding);
  if (!named) return named.error();
  if (named->size() > 1) {
    constexpr std::size_t kMost = 5;
    std::string times;
    for (std::size_t i = 0; i < named->size() && i < kMost; ++i) {
      times += (i == 0 ? "" : ", ") + secondsText((*named)[i].time - session.origin(), 3) + " s";
    }
    if (named->size() > kMost) times += ", ...";
    return Error{ErrorKind::bad_argument,
                 fmt::format("{} events are named `{}`, at {}: give the time", named->size(),
                             plainText(pattern), times),
                 session.log().name()};
  }
  if (!hiding.empty()) {
    return Error{
        ErrorKind::damaged,
        fmt::format("another event `{}` may be missing: {}", plainText(pattern), hiding.what()),
        hiding.where()};
  }
  return named->front().time;
}

bool isSessionTime(std::string_view text) {
  return parseSessionTime(text, LogTime{}, LogTime{}).ok();
}

Result<LogTime> parseMoment(std::string_view text, Timeline& session) {
  const auto time = parseSessionTime(text, session.origin(), session.end());
  if (time.ok() || isSessionTime(text)) return time;
  auto event = momentOfEvent(text, session);
  if (event.ok() || event.error().kind != ErrorKind::not_found) return event;
  return Error{ErrorKind::bad_argument, time.error().what + "; " + event.error().what,
               time.error().where};
}

}  // namespace rocinante
