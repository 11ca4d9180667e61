#include "recorder/export/gltf_export.h"

#include <algorithm>

#include "core/cell/scene_pose_cache.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMomentsPerTell = 256;

}  // namespace

Status recordGltf(MomentWalk& session, const Cell& cell, GltfRecording& recording,
                  const GltfExportOptions& options) {
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
  if (options.every.count() == 0) return session.visit(from + Nanoseconds(1), until, {{}, add});
  for (LogTime moment = from; until - moment > options.every;) {
    moment += options.every;
    const Result<const SessionState*> state = session.stateAt(moment);
    if (!state) return state.error();
    if (Status added = add(moment, **state); !added) return added;
  }
  return {};
}

}  // namespace rocinante
