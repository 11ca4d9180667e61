#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/timeline.h"
#include "golden/suite/suite.h"
#include "golden/suite/suite_frame.h"

namespace rocinante {

/// Which frames of a suite a program works on.
struct FrameSelection {
  std::vector<std::string> only{};      ///< globs over frames' and cases' names; empty: all
  std::vector<std::string> tags{};      ///< one of these; empty: all
  std::vector<std::string> not_tags{};  ///< none of these
  int shard = 1, shards = 1;            ///< the cases that are left are dealt out in turn

  bool isWhole() const { return only.empty() && tags.empty() && not_tags.empty() && shards == 1; }
};

inline constexpr int kMaxShards = 10'000;

/// "2/5".
Result<std::pair<int, int>> parseShard(std::string_view text);

/// Every frame of the suite in its order; moments that do not exist say why. bad_argument for a
/// time that cannot be read, and when two frames would have one name. `session` may be null.
Result<std::vector<SuiteFrame>> planFrames(const Suite& suite, Timeline* session);

/// Those that are selected, in the same order. Never empty: bad_argument then, since nothing judged
/// is never yes.
Result<std::vector<SuiteFrame>> selectFrames(std::vector<SuiteFrame> frames,
                                             const FrameSelection& selection, const Suite& suite);

/// Places in `frames` by time, those of one time in order: in this order a session is gone through
/// once.
std::vector<std::size_t> inLogOrder(const std::vector<SuiteFrame>& frames);

}  // namespace rocinante
