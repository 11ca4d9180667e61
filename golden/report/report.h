#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

inline constexpr std::array kFrameVerdicts = {FrameVerdict::different,  FrameVerdict::missing,
                                              FrameVerdict::unstable,   FrameVerdict::incomparable,
                                              FrameVerdict::unexpected, FrameVerdict::expected,
                                              FrameVerdict::same};

/// Everything that the reports of one run tell.
struct SuiteReport {
  std::string suite;                         ///< path as the user gave it
  std::string cell, log;                     ///< what was judged
  std::string renderer;                      ///< RendererKey::text
  std::string session;                       ///< content_sha256; empty without a log
  std::string made_at;                       ///< RFC 3339
  std::string run_command, approve_command;  ///< what reproduces and what accepts all of it
  /// The same for one frame: its name comes behind. Empty: no such command is shown.
  std::string run_one_command, approve_one_command;
  /// What accepts the frames that the page's "Copy the list" tells: "... --from LIST". Empty: the
  /// page offers no list.
  std::string approve_from_command;
  /// Further lines of what it was judged with: name and value.
  std::vector<std::pair<std::string, std::string>> environment;
  int shard = 1, shards = 1;  ///< of a suite that was dealt out
  std::vector<std::string>
      notes;  ///< about the suite itself: idle masks, loose limits, stale goldens
  std::vector<JudgedFrame> frames;

  std::size_t count(FrameVerdict verdict) const;
  /// same when every frame is fine; incomparable when one is, and nothing worse, or there is none;
  /// else different.
  Verdict verdict() const;
};

/// True for a frame that may become a golden: it was drawn, is steady, and is not one already.
bool canApprove(const JudgedFrame& judged);

/// {"format": 1, "verdict": ..., "counts": {...}, "frames": [...]}
std::string reportJson(const SuiteReport& report);
/// JUnit XML: one testsuite, one testcase a frame; incomparable ones are errors.
std::string reportJunit(const SuiteReport& report);
}  // namespace rocinante
