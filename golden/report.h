#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "golden/run_suite.h"

namespace rocinante {

/// Everything that the reports of one run tell.
struct SuiteReport {
  std::string suite;                         ///< path as the user gave it
  std::string cell, log;                     ///< what was judged
  std::string renderer;                      ///< RendererKey::text
  std::string session;                       ///< content_sha256; empty without a log
  std::string made_at;                       ///< RFC 3339
  std::string run_command, approve_command;  ///< what reproduces and what accepts
  std::vector<JudgedFrame> frames;

  std::size_t count(FrameVerdict verdict) const;
  /// same when every frame is; different when one is different, missing or unstable; else
  /// incomparable.
  Verdict verdict() const;
};

/// {"format": 1, "verdict": ..., "counts": {...}, "frames": [...]}
std::string reportJson(const SuiteReport& report);
/// JUnit XML: one testsuite, one testcase a frame; incomparable ones are errors.
std::string reportJunit(const SuiteReport& report);
/// One self-contained page: no network, pictures inside.
std::string reportHtml(const SuiteReport& report);

/// Writes folder/index.html and, for each frame that is not the same, NAME.frame.png,
/// NAME.golden.png and NAME.difference.png. The folder is made.
Status writeReport(const SuiteReport& report, const std::filesystem::path& folder);

}  // namespace rocinante
