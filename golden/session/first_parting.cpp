#include "golden/session/first_parting.h"

#include <algorithm>

namespace rocinante {

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

}  // namespace rocinante
