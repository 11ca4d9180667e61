#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/approval/manifest.h"
#include "golden/compare/compare.h"
#include "golden/compare/picture_mask.h"
#include "golden/suite/suite_frame.h"
#include "viewer/picture/picture.h"

namespace rocinante {

struct FrameWhy;

enum class FrameVerdict : std::uint8_t {
  same,
  different,
  missing,       ///< no golden was ever approved
  unstable,      ///< drawn again, the frame differs from itself
  incomparable,  ///< not judged: no such moment, no golden of this key, another shape ...
  expected,      ///< different, as the case says it will be: no failure
  unexpected     ///< same, though the case says that it will be different
};
std::string_view nameOf(FrameVerdict verdict);
/// False when a person is needed: all but same and expected.
bool isFine(FrameVerdict verdict);

/// A judged frame: all that a report tells of it. Pictures are kept for those that are not fine.
struct JudgedFrame {
  SuiteFrame frame;
  FrameVerdict verdict = FrameVerdict::incomparable;
  std::string rule;         ///< the rule and figures that decided
  Tolerance tolerance;      ///< what judged: the case's, or SuiteCase::across_keys
  std::string limit_from;   ///< "the default", "s.toml:12", "[tolerance.arm] of s.toml:4"
  std::string expectation;  ///< why the case is expected to differ; empty when it is not
  Comparison comparison;
  /// How many pixels each mask hides: first the case's own, then what the golden's hid besides.
  std::vector<PictureMask::Part> masks;
  std::size_t own_masks = 0;
  std::string key;                        ///< renderer, size, samples
  std::string pixels;                     ///< hash of what was drawn
  std::string inputs;                     ///< hash of what it was drawn from
  std::string session;                    ///< content_sha256 of the log
  std::optional<AcceptedPicture> golden;  ///< the nearest accepted one
  std::optional<Picture> drawn, accepted;
  std::optional<Picture> unmasked;      ///< drawn, with the golden's pixels where masks hide
  std::optional<Picture> thumbnail;     ///< of a frame that is fine: small, for the report
  std::shared_ptr<const FrameWhy> why;  ///< who and what differs, where that was asked for
  /// What draws and what accepts this frame, where its report puts several suites together.
  std::string run_command{}, approve_command{};

  /// What was held against `accepted`: requires that something was drawn.
  const Picture& compared() const { return unmasked ? *unmasked : *drawn; }
  double render_ms = 0, judge_ms = 0;
};

}  // namespace rocinante
