#include "core/copy/log_preceding.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "core/log/log_profile.h"
#include "core/session/keyframe.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

using std::chrono::seconds;

/// How far back to search for the beginning of an unfinished restatement. Each is abandoned after a
/// second, so only an unbroken chain of them reaches further.
constexpr Nanoseconds kMaxLead = seconds(10);

constexpr std::uint64_t kProgressEvery = 4096;

/// Reads from the reader's position; `take` returns whether to continue.
Status readWhile(LogReader& reader, const std::function<Result<bool>(const LogMessage&)>& take) {
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    if (!*message) return {};
    const Result<bool> on = take(**message);
    if (!on) return on.error();
    if (!*on) return {};
  }
}

constexpr LogTime kBeforeAll = LogTime::min();

/// Continues the fold `start`, of everything up to and including `base`, to `from`; finds the lead
/// if a restatement is open there.
Result<Preceding> foldUpTo(LogReader& reader, Selection& selection, const SessionState& start,
                           LogTime base, LogTime from, const CopyProgress& progress) {
  const auto go_to_start = [&] {
    return base == kBeforeAll ? reader.rewind() : reader.seek(base + Nanoseconds(1));
  };
  const LogTime begin = reader.summary().start;
  const double span = static_cast<double>(std::max<std::int64_t>((from - begin).count(), 1));
  std::uint64_t count = 0;
  /// The last place after which no restatement was open; empty: the start.
  std::optional<LogPosition> closed;
  std::optional<LogTime> first_open;  ///< of the first message after it
  bool was_ever_closed = !start.restatementOpen();
  SelectionFold fold(selection, start);
  if (Status there = go_to_start(); !there) return there.error();
  Status read = readWhile(reader, [&](const LogMessage& message) -> Result<bool> {
    if (message.log_time >= from) return false;
    if (progress && ++count % kProgressEvery == 0) {
      const double part = static_cast<double>((message.log_time - begin).count()) / span;
      if (Status on = progress(part); !on) return on.error();
    }
    fold.fold(message);
    if (!fold.state().restatementOpen(message.log_time)) {
      closed = message.place();
      first_open.reset();
      was_ever_closed = true;
    } else if (!first_open) {
      first_open = message.log_time;
    }
    return true;
  });
  if (!read) return read.error();
  Preceding preceding;
  preceding.moment = from;
  const bool open = fold.state().restatementOpen(from);
  if (!open || !was_ever_closed || !first_open || from - *first_open > kMaxLead) {
    preceding.restatement_cut = open;
    preceding.state = fold.takeState();
    return preceding;
  }
  SelectionFold again(selection, start);
  if (Status there = go_to_start(); !there) return there.error();
  read = readWhile(reader, [&](const LogMessage& message) -> Result<bool> {
    if (!closed || message.place() > *closed) return false;
    again.fold(message);
    return true;
  });
  if (!read) return read.error();
  preceding.state = again.takeState();
  preceding.moment = *first_open;
  preceding.lead = closed.value_or(LogPosition{base, std::numeric_limits<std::uint64_t>::max()});
  return preceding;
}

}  // namespace

Result<std::optional<LogMessage>> openingKeyframe(LogReader& reader, std::string& fault) {
  if (Status there = reader.rewind(); !there) return there.error();
  while (true) {
    Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    if (!*message || (*message)->channel->folded()) return std::optional<LogMessage>();
    if ((*message)->channel->topic != profile::kKeyframeTopic) continue;
    const Result<SessionState> state =
        KeyframeReader().read((*message)->payload, (*message)->log_time);
    if (state) return message;
    fault = state.error().what;
  }
}

void SelectionFold::fold(const LogMessage& message) {
  if (selection_.includes(message)) folder_.fold(state_, message);
}

SessionState wantedKeyframeState(ByteView payload, LogTime moment, const Selection& selection,
                                 Nanoseconds shift) {
  PacketTextDecoder decoder;
  SessionState state;
  std::vector<Statement> statements;
  std::string_view rest = textOf(payload);
  while (!rest.empty()) {
    const std::size_t end = rest.find("\n\n");
    const Packet* const packet = decoder.decode(bytesOf(rest.substr(0, end)));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
    if (packet == nullptr || !selection.selectsRestated(*packet)) continue;
    statements.assign(packet->statements.begin(), packet->statements.end());
    for (Statement& statement : statements) {
      if (statement.kind == StatementKind::seen) statement.seen_ns += shift.count();
    }
    Packet wanted = *packet;
    wanted.statements = statements;
    // The selected rest of a restatement is never completed, so it must not remove anything.
    wanted.header.part.reset();
    state.apply(moment + shift, wanted);
  }
  return state;
}

Result<Preceding> precedingBySelection(LogReader& reader, Selection& selection,
                                       const SessionState& opening, LogTime from,
                                       const CopyProgress& progress) {
  return foldUpTo(reader, selection, opening, kBeforeAll, from, progress);
}

Result<Preceding> precedingOf(const std::filesystem::path& path, LogTime from) {
  Result<Timeline> timeline = Timeline::open(path);
  if (!timeline) return timeline.error();
  Preceding preceding;
  Result<const SessionState*> state = timeline->stateBefore({from, 0}, &preceding.damage);
  if (!state) return state.error();
  preceding.moment = from;
  preceding.state = **state;
  if (!preceding.state.restatementOpen(from)) return preceding;
  // Rare: a little further back, then message by message.
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  std::string fault;
  const Result<std::optional<LogMessage>> keyframe = openingKeyframe(*reader, fault);
  if (!keyframe) return keyframe.error();
  LogTime beginning = kBeforeAll;
  SessionState opening;
  if (*keyframe) {
    beginning = (*keyframe)->log_time;
    opening = wantedKeyframeState((*keyframe)->payload, beginning, Selection{}, Nanoseconds(0));
  }
  Selection all;
  for (const Nanoseconds back : {Nanoseconds(seconds(1)), Nanoseconds(seconds(3)), kMaxLead}) {
    const LogTime base = from - back;
    // The log's opening state is not a fold of its messages.
    const bool at_start = base <= beginning;
    if (!at_start) {
      state = timeline->stateAt(base, &preceding.damage);
      if (!state) return state.error();
    }
    Result<Preceding> found = foldUpTo(*reader, all, at_start ? opening : SessionState(**state),
                                       at_start ? kBeforeAll : base, from, {});
    if (found) found->damage = preceding.damage;
    if (!found || !found->restatement_cut) return found;
  }
  preceding.restatement_cut = true;
  return preceding;
}

}  // namespace rocinante
