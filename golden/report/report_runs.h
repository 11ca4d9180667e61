#pragma once

#include <string>
#include <vector>

#include "core/report/json_name.h"
#include "core/report/junit.h"
#include "golden/judge/judged_run.h"

namespace rocinante {

/// By how many limits an accepted log may leave what was accepted; further only with --anyway.
inline constexpr double kMostWidening = 10;
bool widensFar(const RunFinding& finding);
/// "arm/elbow is 1.15° beyond what was accepted, more than 10 times its limit of 0.05°"
std::string widensFarText(const RunFinding& finding);

/// The lines that `run` prints: the verdict, then each finding, what changed, and what was not
/// judged.
std::string runText(const JudgedRun& run);
/// Everything that explains the verdict, a sentence each: findings (at most `most`), then changes.
std::vector<std::string> runReasons(const JudgedRun& run, std::size_t most = 100);

/// What a run or a frame judged, and not; read back from a stranger's report.
Json coverageJson(const RunCoverage& coverage);
RunCoverage readCoverage(const nlohmann::json& judged);

Json runsJson(const std::vector<JudgedRun>& runs);
/// Reads what runsJson() writes, from a stranger: skips what is malformed.
std::vector<JudgedRun> readRunsJson(const nlohmann::json& list);

JunitCase junitRun(const std::string& suite, const JudgedRun& run);

}  // namespace rocinante
