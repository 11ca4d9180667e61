#include <algorithm>
#include <array>

#include "core/cell/scene_pose_cache.h"
#include "recorder/export/exports.h"
#include "recorder/export/session_census.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMomentsPerTell = 256;

}  // namespace

Status recordGltf(MomentWalk& session, const Cell& cell, GltfRecording& recording,
                  const GltfExportOptions& options, Account& left_out) {
  const LogSummary& log = session.log().summary();
  const LogTime from = std::max(options.from, log.start);
  const LogTime until = std::min(options.until, log.end + Nanoseconds(1));
  const double whole = std::max(secondsOf(until - from), 1e-9);
  ScenePoseCache poses(cell);
  std::uint64_t moments = 0;
  const auto add = [&](LogTime moment, const SessionState& state) -> Status {
    Status added = recording.add(moment, poses.pose(state), state);
    if (!added || !options.progress || ++moments % kMomentsPerTell != 0) return added;
    return options.progress(std::clamp(secondsOf(moment - from) / whole, 0.0, 1.0));
  };
  if (from >= until) {
    return Error{ErrorKind::not_found, "nothing was recorded in that span", session.log().name()};
  }
  // What was said before holds at the first moment.
  const Result<const SessionState*> first = session.stateAt(from);
  if (!first) return first.error();
  if (Status added = add(from, **first); !added) return added;
  if (from > log.start && !(*first)->drawings().empty()) {
    left_out.leaveOut({.kind = "drawing",
                       .reason = "of before the span; a glTF scene has nothing for it",
                       .count = (*first)->drawings().size(),
                       .severity = Severity::warning});
  }
  SessionCensus census;
  const auto count = [&](const LogMessage& message, const Packet* packet) -> Status {
    census.take(message, packet);
    return {};
  };
  const bool is_grid = options.every.count() > 0;
  const auto moment_of = [&](LogTime moment, const SessionState& state) -> Status {
    return is_grid || moment == from ? Status{} : add(moment, state);
  };
  if (Status done = session.visit(from, until, {count, moment_of}); !done) return done;
  constexpr std::array kUnknownThere = {StatementKind::line,   StatementKind::points,
                                        StatementKind::label,  StatementKind::event,
                                        StatementKind::signal, StatementKind::signals};
  constexpr std::string_view kReason = "a glTF scene has nothing for it";
  census.addStatements(left_out, kUnknownThere, kReason);
  census.addUnread(left_out, "holds no packet");
  addOwnTopics(left_out, session.log(), kReason);
  addAttachments(left_out, session.log(), "not in the scene; `rocinante log extract` writes it");
  if (!is_grid) return {};
  for (LogTime moment = from; until - moment > options.every;) {
    moment += options.every;
    const Result<const SessionState*> state = session.stateAt(moment);
    if (!state) return state.error();
    if (Status added = add(moment, **state); !added) return added;
  }
  return {};
}

}  // namespace rocinante
