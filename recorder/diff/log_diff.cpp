#include "recorder/diff/log_diff.h"

#include <algorithm>

#include "recorder/diff/message_match.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kBetweenProgress = 1U << 14U;

void addToTime(const MatchItem& a, const MatchItem& b, bool first, TimeDiff& diff) {
  const Nanoseconds shift = b.place.time - a.place.time;
  diff.least = first ? shift : std::min(diff.least, shift);
  diff.most = first ? shift : std::max(diff.most, shift);
  if (shift == Nanoseconds(0)) return;
  if (diff.moved++ == 0) {
    diff.first_a = a.place;
    diff.first_shift = shift;
  }
  if (!diff.largest_a || std::chrono::abs(shift) > std::chrono::abs(diff.largest_shift)) {
    diff.largest_a = a.place;
    diff.largest_shift = shift;
  }
}

Status diffMessages(LogReader& a, LogReader& b, LogDiff& diff,
                    const std::function<void(std::uint64_t)>& progress) {
  for (LogReader* reader : {&a, &b}) {
    if (Status rewound = reader->rewind(); !rewound) return rewound;
  }
  MessageMatch match(a, b);
  PayloadDiff payload;
  TimeDiff time;
  for (std::uint64_t steps = 0;; ++steps) {
    const Result<std::optional<MessageMatch::Step>> step = match.next();
    if (!step) return step.error();
    if (!*step) break;
    const auto& [in_a, in_b] = **step;
    if (in_a && in_b) {
      addToTime(*in_a, *in_b, payload.same == 0, time);
      ++payload.same;
    } else {
      ++(in_a ? payload.only_a : payload.only_b);
    }
    if (steps % kBetweenProgress == 0) progress(match.count(0));
  }
  if (match.firstParting()) {
    payload.differs = true;
    payload.first_a = match.firstParting()->a;
    payload.first_b = match.firstParting()->b;
  }
  diff.messages_a = match.count(0);
  diff.messages_b = match.count(1);
  diff.payload = std::move(payload);
  diff.time = std::move(time);
  return {};
}

}  // namespace

Result<LogDiff> diffLogs(LogReader& a, LogReader& b, DiffBy by,
                         const std::function<void(double)>& progress) {
  LogDiff diff;
  diff.name_a = a.name();
  diff.name_b = b.name();
  diff.origin_a = a.summary().origin;
  diff.origin_b = b.summary().origin;
  diff.messages_a = a.summary().messages;
  diff.messages_b = b.summary().messages;
  const auto tell = [&](double part) {
    if (progress) progress(std::clamp(part, 0.0, 1.0));
  };
  if (by != DiffBy::state) {
    const auto expected = static_cast<double>(std::max<std::uint64_t>(1, diff.messages_a));
    const Status done = diffMessages(
        a, b, diff, [&](std::uint64_t read) { tell(static_cast<double>(read) / expected); });
    if (!done) return done.error();
    if (by == DiffBy::payload) diff.time.reset();
  }
  if (by == DiffBy::state || by == DiffBy::all) {
    const LogTime start = a.summary().start;
    const auto span = static_cast<double>((a.summary().end - start).count() + 1);
    Result<StateDiff> state = diffStates(
        a, b, [&](LogTime moment) { tell(static_cast<double>((moment - start).count()) / span); });
    if (!state) return state.error();
    diff.state = std::move(*state);
  }
  return diff;
}

}  // namespace rocinante
