#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "golden/compare.h"
#include "golden/manifest.h"
#include "golden/suite.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// One moment of a case: what a golden belongs to. A case with `every` gives many.
struct SuiteFrame {
  std::string name;  ///< of the case; with `every`: NAME-00012.500s
  const SuiteCase* suite_case = nullptr;
  std::optional<LogTime> time;  ///< empty: the moment does not exist; `why` says why
  std::string why;
};

enum class FrameVerdict : std::uint8_t { same, different, missing, unstable, incomparable };
std::string_view nameOf(FrameVerdict verdict);

/// A judged frame. Pictures are kept for those that are not the same.
struct JudgedFrame {
  SuiteFrame frame;
  FrameVerdict verdict = FrameVerdict::incomparable;
  std::string rule;  ///< the rule and figures that decided, and where the limit came from
  Comparison comparison;
  std::string key;                        ///< renderer, size, samples
  std::string pixels;                     ///< hash of what was drawn
  std::string inputs;                     ///< hash of what it was drawn from
  std::string session;                    ///< content_sha256 of the log
  std::optional<AcceptedPicture> golden;  ///< the nearest accepted one
  std::optional<Picture> drawn, accepted;
  std::optional<Picture> thumbnail;  ///< of a frame that is the same: small, for the report
  double render_ms = 0, judge_ms = 0;
};

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
