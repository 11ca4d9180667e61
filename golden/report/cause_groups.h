#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "golden/report/report.h"

namespace rocinante {

/// Frames that are not fine for one cause.
struct CauseGroup {
  /// "in all 9 frames: joint elbow_joint of ur10 has moved by 20 mm"; empty for frames without a
  /// known cause.
  std::string sentence;
  std::vector<std::string> also;  ///< further causes that all of them have
  std::vector<const JudgedFrame*> frames;
};

/// Groups in the order of their first frames. Borrows the report's frames.
std::vector<CauseGroup> causeGroups(const std::vector<JudgedFrame>& frames);

/// The sentence of the frame's group; empty without one.
std::string causeSentence(const std::vector<CauseGroup>& groups, const JudgedFrame& judged);

/// What decided, after the frame's own cause where its group's sentence does not give it:
/// "arm/joint4: 23.61° -> 24.12°; 412 differing pixels (exact), limit from the default".
std::string ruleText(const CauseGroup& group, const JudgedFrame& judged);

/// "different     front: 412 differing pixels (exact), limit from the default"
std::string frameLine(const JudgedFrame& judged, const std::string& rule);

/// The group for a terminal, without line ends: its sentence, then a line for each further cause
/// and each frame. Of a group with a sentence at most kMostGroupLines, unless `all`: then "and N
/// more" counts causes and names frames, by verdict.
inline constexpr std::size_t kMostGroupLines = 10;
std::vector<std::string> groupLines(const CauseGroup& group, bool all);

/// The first sentence about a report: of its frames' first group, else of its first run that is
/// not fine: "run lift: ..."; empty when all is fine or nothing is known.
std::string firstSentence(const SuiteReport& report);

}  // namespace rocinante
