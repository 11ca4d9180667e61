#include "core/session/moment_walk.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/duration_text.h"
#include "core/log/damage_text.h"

namespace rocinante {

Result<MomentWalk> MomentWalk::open(const std::filesystem::path& path) {
  // Two readers: one says when, and what was said; the other folds up to there.
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  Result<Timeline> timeline = Timeline::open(path);
  if (!timeline) return timeline.error();
  return MomentWalk(std::move(*reader), std::move(*timeline));
}

Status MomentWalk::visit(LogTime from, LogTime until, const MomentVisitor& visitor) {
  if (Status found = reader_.seek(from); !found) return found;
  std::optional<LogTime> reached;
  const auto finish = [&]() -> Status {
    if (!reached || !visitor.moment) return {};
    const Result<const SessionState*> state = stateAt(*reached);
    if (!state) return state.error();
    return visitor.moment(*reached, **state);
  };
  while (true) {
    const Result<std::optional<LogMessage>> message = reader_.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time >= until) break;
    if (!(*message)->channel->folded()) continue;
    if (reached && *reached != (*message)->log_time) {
      if (Status finished = finish(); !finished) return finished;
    }
    reached = (*message)->log_time;
    if (!visitor.message) continue;
    if (Status visited = visitor.message(**message, folder_.decode(**message)); !visited) {
      return visited;
    }
  }
  return finish();
}

Result<const SessionState*> MomentWalk::stateAt(LogTime moment) {
  StateDamage accepted;  // damage() lists it
  return timeline_.stateAt(moment, &accepted);
}

Result<const std::vector<Event>*> MomentWalk::events() {
  StateDamage accepted;  // damage() lists it
  return timeline_.events(&accepted);
}

std::vector<std::string> MomentWalk::damage() const {
  std::vector<std::string> sentences;
  const LogReader& log = timeline_.log();
  for (const KeyframeFault& fault : timeline_.keyframeFaults()) {
    sentences.push_back(fmt::format("the keyframe at {} s is ignored: {} ({})",
                                    secondsText(fault.time - log.summary().origin, 3), fault.cause,
                                    log.name()));
  }
  // Both read the same file, but perhaps not the same parts of it.
  const std::vector<DamageSpan>& most =
      log.damage().size() > reader_.damage().size() ? log.damage() : reader_.damage();
  for (const DamageSpan& span : most) {
    sentences.push_back(damageText(span, log.name()));
  }
  return sentences;
}

}  // namespace rocinante
