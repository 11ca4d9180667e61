#include "golden/report/cause_groups.h"

#include <fmt/format.h>

#include <algorithm>

#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

/// What frames of one group share; empty when the cause is not known.
std::string keyOf(const JudgedFrame& judged) {
  if (!judged.why || judged.why->causes.empty()) return {};
  const FrameWhy& why = *judged.why;
  // Pixels alone are the effect of whatever made the frame incomparable or unstable.
  const bool has_cause = !why.files.empty() || !why.state.empty();
  const bool is_judged = judged.verdict == FrameVerdict::different;
  if (!is_judged && !has_cause) return {};
  return why.common_cause.empty() ? why.causes.front() : why.common_cause;
}

void keepShared(const JudgedFrame& judged, std::vector<std::string>& also) {
  std::erase_if(also, [&](const std::string& cause) {
    return std::ranges::find(judged.why->causes, cause) == judged.why->causes.end();
  });
}

std::string placeText(std::size_t count, std::size_t all, const std::string& first) {
  if (count == 1) return "in frame " + first;
  if (count == 2 && all == 2) return "in both frames";
  return count == all ? fmt::format("in all {} frames", all)
                      : fmt::format("in {} of {} frames", count, all);
}

}  // namespace

std::vector<CauseGroup> causeGroups(const std::vector<JudgedFrame>& frames) {
  std::vector<CauseGroup> groups;
  for (const JudgedFrame& judged : frames) {
    if (isFine(judged.verdict)) continue;
    const std::string key = keyOf(judged);
    auto group = std::ranges::find(groups, key, &CauseGroup::sentence);
    if (group == groups.end()) {
      groups.push_back({key, {}, {}});
      group = groups.end() - 1;
      if (!key.empty()) group->also = {judged.why->causes.begin() + 1, judged.why->causes.end()};
    } else if (!key.empty()) {
      keepShared(judged, group->also);
    }
    group->frames.push_back(&judged);
  }
  for (CauseGroup& group : groups) {
    if (group.sentence.empty()) continue;
    const JudgedFrame& first = *group.frames.front();
    group.sentence =
        fmt::format("{}: {}", placeText(group.frames.size(), frames.size(), first.frame.name),
                    group.frames.size() == 1 ? first.why->causes.front() : group.sentence);
  }
  return groups;
}

std::string causeSentence(const std::vector<CauseGroup>& groups, const JudgedFrame& judged) {
  for (const CauseGroup& group : groups) {
    if (std::ranges::find(group.frames, &judged) != group.frames.end()) return group.sentence;
  }
  return {};
}

std::string ruleText(const CauseGroup& group, const JudgedFrame& judged) {
  const bool has_own =
      !group.sentence.empty() && group.frames.size() > 1 && !judged.why->common_cause.empty();
  return has_own ? judged.why->causes.front() + "; " + judged.rule : judged.rule;
}

std::string firstSentence(const SuiteReport& report) {
  for (const CauseGroup& group : causeGroups(report.frames)) {
    if (!group.sentence.empty()) return group.sentence;
  }
  for (const JudgedRun& run : report.runs) {
    if (!isFine(run.verdict)) return "run " + run.name + ": " + run.rule;
  }
  return {};
}

}  // namespace rocinante
