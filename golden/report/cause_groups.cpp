#include "golden/report/cause_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/plain_text.h"
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

constexpr std::size_t kMostCauses = 3;

/// Of `count` lines where only `most` are wanted: one of these says how many are left out.
std::size_t shownOf(std::size_t count, std::size_t most) {
  return count <= most ? count : most - 1;
}

/// "different     and 2 more: late, later", a line for each verdict.
std::vector<std::string> restLines(const std::vector<const JudgedFrame*>& frames) {
  std::vector<std::string> lines;
  for (const FrameVerdict verdict : kFrameVerdicts) {
    std::string names;
    std::size_t count = 0;
    for (const JudgedFrame* const judged : frames) {
      if (judged->verdict != verdict) continue;
      names += (names.empty() ? "" : ", ") + judged->frame.name;
      ++count;
    }
    if (count > 0) {
      lines.push_back(fmt::format("{:<13} and {} more: {}", nameOf(verdict), count, names));
    }
  }
  return lines;
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

std::string frameLine(const JudgedFrame& judged, const std::string& rule) {
  return fmt::format("{:<13} {}: {}", nameOf(judged.verdict), judged.frame.name, rule);
}

std::vector<std::string> groupLines(const CauseGroup& group, bool all) {
  std::vector<std::string> lines;
  if (!group.sentence.empty()) lines.push_back(plainText(group.sentence));
  all = all || lines.size() + group.also.size() + group.frames.size() <= kMostGroupLines ||
        group.sentence.empty();
  const std::size_t causes = all ? group.also.size() : shownOf(group.also.size(), kMostCauses);
  for (std::size_t i = 0; i < causes; ++i) lines.push_back("    " + plainText(group.also[i]));
  if (causes < group.also.size()) {
    lines.push_back(fmt::format("    and {} more", group.also.size() - causes));
  }
  std::size_t shown = group.frames.size();
  if (!all && lines.size() + shown > kMostGroupLines) {
    std::set<FrameVerdict> verdicts;
    for (const JudgedFrame* const judged : group.frames) verdicts.insert(judged->verdict);
    shown = kMostGroupLines - lines.size() - verdicts.size();
  }
  for (std::size_t i = 0; i < shown; ++i) {
    lines.push_back(frameLine(*group.frames[i], plainText(ruleText(group, *group.frames[i]))));
  }
  const std::vector<std::string> rest =
      restLines({group.frames.begin() + shown, group.frames.end()});
  lines.insert(lines.end(), rest.begin(), rest.end());
  return lines;
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
