#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/judged_frame.h"
#include "golden/judge/judged_run.h"

namespace rocinante {

inline constexpr std::array kFrameVerdicts = {FrameVerdict::different,  FrameVerdict::missing,
                                              FrameVerdict::unstable,   FrameVerdict::incomparable,
                                              FrameVerdict::unexpected, FrameVerdict::expected,
                                              FrameVerdict::same};

/// The data of all reports of one run.
struct SuiteReport {
  std::string suite;                         ///< path as the user gave it
  std::string cell, log;                     ///< the judged files
  std::string renderer;                      ///< RendererKey::text
  std::string session;                       ///< content_sha256; empty without a log
  std::string decoded{};                     ///< decoded_sha256; empty without decoded packets
  std::string made_at;                       ///< RFC 3339
  std::string run_command, approve_command;  ///< commands: repeat, accept all
  /// The same for one frame, whose name is appended. Empty: not shown.
  std::string run_one_command, approve_one_command;
  /// Command that accepts the frames of the page's "Copy the list": "... --from LIST". Empty: the
  /// page offers no list.
  std::string approve_from_command;
  /// Further lines about the environment: name and value.
  std::vector<std::pair<std::string, std::string>> environment;
  /// Files of the cell, when some frame may be approved; empty: unknown.
  FileHashes cell_files{};
  int shard = 1, shards = 1;  ///< of a sharded suite
  std::vector<std::string>
      notes;  ///< about the suite itself: idle masks, loose limits, stale goldens
  std::vector<JudgedFrame> frames;
  std::vector<JudgedRun> runs{};
  /// Pages of the sessions that go beside the report: file name and text.
  std::vector<std::pair<std::string, std::string>> pages{};

  std::size_t count(FrameVerdict verdict) const;
  /// same when every frame and run is fine; incomparable when the worst one is, or when there are
  /// none; otherwise different.
  Verdict verdict() const;
};

/// The page of the suite's log beside a report, and that of a run's own.
inline const std::string kSessionPageFile = "session.html";
inline std::string runPageFile(const JudgedRun& run) { return run.name + ".run.html"; }

/// A copy of a run's log beside the report, which `approve --artifact` takes.
inline std::string runLogFile(const JudgedRun& run) { return run.name + ".run.mcap"; }
inline constexpr std::uint64_t kMaxRunLogBytes = std::uint64_t{64} << 20U;
/// True for a run whose log may be accepted by a list: it was not accepted yet, is known, and is
/// not refused without --anyway.
bool canApproveRun(const JudgedRun& run);
/// True for a frame that may become a golden: it was drawn, is stable, and is not one already.
bool canApprove(const JudgedFrame& judged);

/// {"format": 1, "verdict": ..., "counts": {...}, "frames": [...]}
std::string reportJson(const SuiteReport& report);
/// JUnit XML: one testsuite, one testcase per frame; incomparable frames are errors.
std::string reportJunit(const SuiteReport& report);
}  // namespace rocinante
