#include "core/recording/condition.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/duration_text.h"
#include "core/base/pattern.h"

namespace rocinante {
namespace {

constexpr std::array<std::pair<std::string_view, Condition::Kind>, 4> kKinds{
    {{"event", Condition::Kind::event},
     {"source", Condition::Kind::source},
     {"device", Condition::Kind::device},
     {"silence", Condition::Kind::silence}}};

bool meets(const Condition& condition, const Packet& packet) {
  switch (condition.kind) {
    case Condition::Kind::source:
      return patternMatches(condition.pattern, packet.header.source);
    case Condition::Kind::event:
      return std::ranges::any_of(packet.statements, [&](const Statement& statement) {
        return statement.kind == StatementKind::event &&
               patternMatches(condition.pattern, statement.text);
      });
    case Condition::Kind::device:
      return std::ranges::any_of(packet.statements, [&](const Statement& statement) {
        const std::string_view device = isSignal(statement.kind)     ? statement.path.first
                                        : isOfDevice(statement.kind) ? statement.name
                                                                     : std::string_view();
        return !device.empty() && patternMatches(condition.pattern, device);
      });
    case Condition::Kind::silence:
      break;
  }
  return false;
}

}  // namespace

Result<Condition> Condition::parse(std::string_view text) {
  const std::size_t equals = text.find('=');
  Condition condition;
  condition.pattern = text;
  if (equals != std::string_view::npos) {
    const auto known = std::ranges::find(kKinds, text.substr(0, equals),
                                         &std::pair<std::string_view, Kind>::first);
    if (known == kKinds.end()) {
      return Error{ErrorKind::bad_argument,
                   "a condition is event=TEXT, source=NAME, device=NAME or silence=TIME",
                   std::string(text)};
    }
    condition.kind = known->second;
    condition.pattern = text.substr(equals + 1);
  }
  if (condition.pattern.empty()) {
    return Error{ErrorKind::bad_argument, "a condition needs a value", std::string(text)};
  }
  if (condition.kind != Kind::silence) return condition;
  const Result<Nanoseconds> silence = parseDuration(condition.pattern);
  if (!silence) return silence.error();
  if (*silence <= Nanoseconds(0)) {
    return Error{ErrorKind::bad_argument, "a silence must be longer than zero", std::string(text)};
  }
  condition.silence = *silence;
  return condition;
}

std::string Condition::text() const {
  const auto known = std::ranges::find(kKinds, kind, &std::pair<std::string_view, Kind>::second);
  return std::string(known->first) + "=" + pattern;
}

ConditionWatch::ConditionWatch(std::vector<Condition> conditions) {
  for (Condition& each : conditions) {
    listens_ = listens_ || each.kind != Condition::Kind::silence;
    watched_.push_back({std::move(each)});
  }
}

const Condition* ConditionWatch::metBy(LogTime time, const Packet* packet) {
  last_ = time;
  const Condition* met = nullptr;
  if (!listens_) {
    for (Watched& each : watched_) each.spent = false;
    return nullptr;
  }
  for (Watched& each : watched_) {
    if (each.condition.kind == Condition::Kind::silence) {
      each.spent = false;
      continue;
    }
    if (each.spent || packet == nullptr || !packet->header.by.empty()) continue;
    if (!meets(each.condition, *packet)) continue;
    each.spent = each.condition.kind != Condition::Kind::event;
    if (met == nullptr) met = &each.condition;
  }
  return met;
}

const Condition* ConditionWatch::metBySilence(LogTime reached) {
  if (last_ == LogTime{}) return nullptr;
  for (Watched& each : watched_) {
    if (each.condition.kind != Condition::Kind::silence || each.spent) continue;
    if (reached - last_ < each.condition.silence) continue;
    each.spent = true;
    moment_ = last_ + each.condition.silence;
    return &each.condition;
  }
  return nullptr;
}

}  // namespace rocinante
