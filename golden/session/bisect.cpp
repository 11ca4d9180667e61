#include "golden/session/bisect.h"

#include <algorithm>

#include "core/packet/state_items.h"

namespace rocinante {
namespace {

/// Compares everything in a state that a picture can depend on.
bool drawsAlike(const SessionState& a, const SessionState& b) {
  return sameItems(a, b, [](DeviceState one, const DeviceState& other) {
    one.last_write = other.last_write;
    return one == other;
  });
}

}  // namespace

Result<Parting> findParting(const PartingQuestion& question) {
  Parting parting;
  if (question.first_possible >= question.moments) return parting;
  const auto differs = [&](std::size_t moment) {
    ++parting.frames;
    return question.differs(moment);
  };
  std::vector<std::size_t> probes = {question.first_possible};
  for (const std::size_t probe : question.probes) {
    if (probe > probes.back() && probe < question.moments) probes.push_back(probe);
  }
  if (probes.back() != question.moments - 1) probes.push_back(question.moments - 1);

  std::optional<std::size_t> different;
  std::size_t alike =
      0;  // the last probe that is; counts only when there is one before `different`
  bool has_alike = false;
  for (const std::size_t probe : probes) {
    const auto answer = differs(probe);
    if (!answer.ok()) return answer.error();
    if (*answer) {
      different = probe;
      break;
    }
    alike = probe;
    has_alike = true;
  }
  if (!different) return parting;
  parting.searched_from = has_alike ? alike + 1 : question.first_possible;
  std::size_t first = *different;
  if (first - parting.searched_from <= question.most_frames) {
    for (std::size_t moment = parting.searched_from; moment < *different; ++moment) {
      const auto answer = differs(moment);
      if (!answer.ok()) return answer.error();
      if (*answer) {
        first = moment;
        break;
      }
      alike = moment;
      has_alike = true;
    }
    parting.is_first_since_probe = true;
  } else {
    // Invariant: equal at `alike`, different at `first`.
    while (first - alike > 1) {
      const std::size_t middle = alike + (first - alike) / 2;
      const auto answer = differs(middle);
      if (!answer.ok()) return answer.error();
      (*answer ? first : alike) = middle;
    }
    parting.searched_from = alike + 1;
  }
  parting.first = first;
  if (has_alike) parting.last_alike = alike;
  return parting;
}

Result<BisectAnswer> bisectPictures(const BisectQuestion& question) {
  PartingQuestion parting;
  parting.moments = question.moments.size();
  parting.most_frames = question.most_frames;
  const auto placeOf = [&](Nanoseconds moment) {
    return static_cast<std::size_t>(std::ranges::lower_bound(question.moments, moment) -
                                    question.moments.begin());
  };
  parting.first_possible = placeOf(question.alike_before);
  for (const Nanoseconds probe : question.probes) parting.probes.push_back(placeOf(probe));
  std::ranges::sort(parting.probes);
  parting.differs = [&](std::size_t place) -> Result<bool> {
    const auto a = question.a(question.moments[place]);
    if (!a.ok()) return a.error();
    const auto b = question.b(question.moments[place]);
    if (!b.ok()) return b.error();
    return *a != *b;
  };
  const auto found = findParting(parting);
  if (!found.ok()) return found.error();
  BisectAnswer answer;
  answer.frames = found->frames;
  answer.moments = question.moments.size();
  answer.is_first_since_probe = found->is_first_since_probe;
  if (found->first) {
    answer.first = question.moments[*found->first];
    answer.searched_from = question.moments[found->searched_from];
  }
  if (found->last_alike) answer.last_alike = question.moments[*found->last_alike];
  return answer;
}

Result<std::vector<Nanoseconds>> changesOf(const std::filesystem::path& log) {
  auto reader = LogReader::open(log);
  if (!reader.ok()) return reader.error();
  const LogSummary summary = reader->summary();
  std::vector<Nanoseconds> moments;
  for (;;) {
    const auto message = reader->next();
    if (!message.ok()) return message.error();
    if (!*message) break;
    const LogMessage& its = **message;
    if (!its.channel->folded() || its.log_time < summary.start || its.log_time > summary.end) {
      continue;
    }
    const Nanoseconds moment = its.log_time - summary.origin;
    if (moments.empty() || moments.back() != moment) moments.push_back(moment);
  }
  return moments;
}

Result<std::optional<Nanoseconds>> statesPart(Timeline& a, Timeline& b,
                                              const std::vector<Nanoseconds>& moments) {
  for (const Nanoseconds moment : moments) {
    const auto in_a = a.stateAt(a.origin() + moment);
    if (!in_a.ok()) return in_a.error();
    const auto in_b = b.stateAt(b.origin() + moment);
    if (!in_b.ok()) return in_b.error();
    if (!drawsAlike(**in_a, **in_b)) return std::optional(moment);
  }
  return std::optional<Nanoseconds>();
}

}  // namespace rocinante
