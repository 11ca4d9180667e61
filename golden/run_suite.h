#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "golden/judged_frame.h"
#include "golden/manifest.h"
#include "golden/suite.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

struct SuiteOptions {
  std::optional<std::filesystem::path> cell;  ///< in place of the suite's
  std::optional<std::filesystem::path> log;
  std::string only;  ///< glob over frame names; empty: all
  std::vector<std::filesystem::path> search;
  bool search_environment = false;
  std::function<double()> now_ms;  ///< a steady clock, for the report's timings
  std::function<void(std::size_t done, std::size_t of)> progress;  ///< may be empty
};

/// A suite with its cell, log, renderer and manifest open.
class SuiteSession {
 public:
  static Result<SuiteSession> open(const std::filesystem::path& suite_file,
                                   const SuiteOptions& options);

  const Suite& suite() const { return suite_; }
  const Manifest& manifest() const { return manifest_; }
  /// The selected moments in order of the suite. Never empty: open() refuses that.
  const std::vector<SuiteFrame>& frames() const { return frames_; }
  const RendererKey& key() const { return maker_.key(); }
  const ModelFaults& modelFaults() const { return maker_.cell().faults; }

  /// Draws and judges one. An error only when the renderer fails.
  Result<JudgedFrame> judge(const SuiteFrame& frame);

  /// Draws the frame twice and, when both are equal, makes it the golden of its case and key.
  /// The manifest is written by finishApproval().
  Status approve(const SuiteFrame& frame, std::string by, std::string at, std::string reason);
  Status finishApproval();

 private:
  SuiteSession(Suite suite, Manifest manifest, FrameMaker maker, std::string session,
               SuiteOptions options);
  Status selectFrames();
  Result<Picture> draw(const SuiteFrame& frame);
  std::string keyText(const SuiteCase& suite_case) const;
  void judgeAgainst(const std::vector<const AcceptedPicture*>& goldens, JudgedFrame& judged);

  Suite suite_;
  Manifest manifest_;
  FrameMaker maker_;
  std::string session_;
  SuiteOptions options_;
  std::vector<SuiteFrame> frames_;
};

}  // namespace rocinante
