#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/session/timeline.h"
#include "golden/suite/suite.h"

namespace rocinante {

/// One picture of a case, the unit that has a golden. A case with `every`, `events` or several
/// cameras has many.
struct SuiteFrame {
  std::string name;  ///< CASE[.CAMERA][-MOMENT], unique in its suite
  /// Borrowed from the suite. Null in reports without a suite: merged ones and comparisons of
  /// revisions.
  const SuiteCase* suite_case = nullptr;
  std::optional<LogTime> time;  ///< empty: no such moment, explained by `why`
  std::string why;
  std::string case_name{};
  std::string camera{};  ///< empty: as render chooses
  std::vector<std::string> tags{};
  std::size_t place = 0;  ///< index among all frames of the suite
  int line = 0;           ///< of its case in the suite's file; 0: unknown
};

/// Selects frames of a suite.
struct FrameSelection {
  std::vector<std::string> only{};      ///< patterns of frames' and cases' names; empty: all
  std::vector<std::string> tags{};      ///< any of these; empty: all
  std::vector<std::string> not_tags{};  ///< none of these
  int shard = 1, shards = 1;            ///< the remaining cases are dealt out in turn

  bool isWhole() const { return only.empty() && tags.empty() && not_tags.empty() && shards == 1; }
};

inline constexpr int kMaxShards = 10'000;

/// "2/5".
Result<std::pair<int, int>> parseShard(std::string_view text);

/// All frames of the suite in its order; frames without a moment have a `why`. bad_argument for an
/// invalid time, and when two frames would have the same name. `session` may be null.
Result<std::vector<SuiteFrame>> planFrames(const Suite& suite, Timeline* session);

/// The selected frames in the same order. bad_argument when none is selected, so that an empty run
/// cannot pass.
Result<std::vector<SuiteFrame>> selectFrames(std::vector<SuiteFrame> frames,
                                             const FrameSelection& selection, const Suite& suite);

/// The selected runs of the suite, by the same patterns and tags; for shards they follow the cases
/// of `frames`, all of the suite. May be empty.
std::vector<const SuiteRun*> selectRuns(const Suite& suite, const std::vector<SuiteFrame>& frames,
                                        const FrameSelection& selection);

/// A camera's name or an event's text as part of a frame's name; other characters become `_`.
std::string fileWord(std::string_view text);

/// Indices of `frames` sorted by time, stable, so that a session is read once.
std::vector<std::size_t> inLogOrder(const std::vector<SuiteFrame>& frames);

}  // namespace rocinante
