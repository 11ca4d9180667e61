#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/core/log/log_steps.h"

namespace rocinante::test {
namespace {

// The comparisons are plain functions that name the first fault: a property with an assertion at
// every step takes minutes to compile with sanitizers.

std::vector<KeptMessage> readBackwards(LogReader& reader) {
  std::vector<KeptMessage> messages;
  while (const std::optional<LogMessage> message = *reader.previous()) {
    messages.push_back(keep(*message));
  }
  return messages;
}

Ending anyEnding() {
  return *rc::gen::element(Ending::closed, Ending::without_magic, Ending::killed);
}

std::string turningFault(const Bytes& file, const std::vector<Step>& written, std::int64_t moment) {
  LogReader reader = openLog(file);
  if (!readBackwards(reader).empty()) return "something comes before the beginning";
  const std::vector<KeptMessage> all = expected(written);
  std::vector<KeptMessage> before = all;
  std::erase_if(before, [&](const KeptMessage& each) { return each.log_time_ns >= moment; });
  std::ranges::reverse(before);
  if (!reader.seek(at(moment))) return "cannot seek";
  if (readBackwards(reader) != before) return "backwards from the moment";
  if (readAll(reader) != all) return "forwards from the beginning";
  std::vector<KeptMessage> reversed = all;
  std::ranges::reverse(reversed);
  if (readBackwards(reader) != reversed) return "backwards from the end";
  return {};
}

RC_GTEST_PROP(LogDirection, BackwardsIsForwardsReversedFromAnyMoment, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  const std::int64_t moment = *rc::gen::inRange(0, 61);
  RC_ASSERT(turningFault(file, written, moment) == "");
}

/// The next step, and a number for its target.
using Move = std::pair<int, int>;

/// Steps in both directions, with jumps between, against a plain list.
std::string walkFault(const Bytes& file, const std::vector<Step>& written,
                      const std::vector<Move>& moves) {
  const std::vector<KeptMessage> all = expected(written);
  LogReader reader = openLog(file);
  std::vector<LogPosition> places;
  while (const std::optional<LogMessage> message = *reader.next()) {
    places.push_back(message->place());
  }
  if (places.size() != all.size()) return "not everything is there";
  std::size_t here = all.size();
  for (const auto& [kind, number] : moves) {
    if (kind == 0) {
      if (!reader.seek(at(number % 61))) return "cannot seek";
      here = all.size() - expected(written, number % 61).size();
    } else if (kind == 1 && !all.empty()) {
      const std::size_t after = static_cast<std::size_t>(number) % all.size();
      if (!reader.seekAfter(places[after])) return "cannot go behind a place";
      here = after + 1;
    } else if (kind % 2 == 0) {
      const std::optional<LogMessage> message = *reader.next();
      if (message.has_value() != (here < all.size())) return "next() ends elsewhere";
      if (message && keep(*message) != all[here++]) return "next() gives another";
    } else {
      const std::optional<LogMessage> message = *reader.previous();
      if (message.has_value() != (here > 0)) return "previous() ends elsewhere";
      if (message && keep(*message) != all[--here]) return "previous() gives another";
    }
  }
  return {};
}

RC_GTEST_PROP(LogDirection, AnyWalkGoesOverTheSameMessages, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  const std::vector<Move> moves = *rc::gen::container<std::vector<Move>>(
      rc::gen::pair(rc::gen::inRange(0, 12), rc::gen::inRange(0, 1 << 20)));
  RC_ASSERT(walkFault(file, written, moves) == "");
}

std::string lastOfFault(const Bytes& file, const std::vector<Step>& written,
                        const std::vector<Move>& questions) {
  LogReader reader = openLog(file);
  for (const auto& [channel, moment] : questions) {
    // By channel, not by topic: several channels share one.
    const Step* wanted = nullptr;
    for (const Step& step : written) {
      if (step.channel != channel || step.time_ns > moment) continue;
      if (wanted == nullptr || step.time_ns >= wanted->time_ns) wanted = &step;
    }
    const std::optional<LogMessage> next = *reader.next();
    const bool at_end = !next;
    const LogPosition place = next ? next->place() : LogPosition{};
    const std::optional<LogMessage> last =
        *reader.lastOf(static_cast<ChannelId>(channel), at(moment));
    if (last.has_value() != (wanted != nullptr)) return "there is one, or there is none";
    if (last && (last->channel->id != channel || last->log_time != at(wanted->time_ns) ||
                 textOf(last->payload) != wanted->payload)) {
      return "another is the last";
    }
    const std::optional<LogMessage> same = *reader.previous();
    if (!at_end && !(same && same->place() == place)) {
      return "the reader has moved";
    }
  }
  for (const DamageSpan& damage : reader.damage()) {
    // A file that was not closed counts as damaged.
    if (damage.cause.find("never") == std::string::npos &&
        damage.cause.find("the file ends inside its summary") == std::string::npos) {
      return damage.cause;
    }
  }
  return {};
}

RC_GTEST_PROP(LogDirection, TheLastOfAChannelIsFoundFromAnywhere, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  const std::vector<Move> questions = *rc::gen::container<std::vector<Move>>(
      rc::gen::pair(rc::gen::inRange(0, 5), rc::gen::inRange(-1, 61)));
  RC_ASSERT(lastOfFault(file, written, questions) == "");
}

}  // namespace
}  // namespace rocinante::test
