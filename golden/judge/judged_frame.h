#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/behaviour/run_coverage.h"
#include "golden/approval/manifest.h"
#include "golden/compare/compare.h"
#include "golden/compare/picture_mask.h"
#include "golden/suite/suite_plan.h"
#include "viewer/picture/picture.h"

namespace rocinante {

struct FrameWhy;

enum class FrameVerdict : std::uint8_t {
  same,
  different,
  missing,       ///< no golden was approved yet
  unstable,      ///< drawn again, the frame differs from itself
  incomparable,  ///< not judged: no such moment, no golden of this key, another shape ...
  expected,      ///< different, as the case expects: not a failure
  unexpected     ///< same, though the case expects a difference
};
std::string_view nameOf(FrameVerdict verdict);
/// True for same and expected; a person must look at all others.
bool isFine(FrameVerdict verdict);

/// A judged frame with all data for reports. Pictures are kept unless the frame is `same`.
struct JudgedFrame {
  SuiteFrame frame;
  FrameVerdict verdict = FrameVerdict::incomparable;
  std::string rule;         ///< the rule and figures that decided
  Tolerance tolerance;      ///< the case's, or SuiteCase::across_keys
  std::string limit_from;   ///< "the default", "s.toml:12", "[tolerance.arm] of s.toml:4"
  std::string expectation;  ///< why a difference is expected; empty: it is not
  Comparison comparison;
  /// Pixels hidden by each mask: first the case's masks, then those the golden's masks hid in
  /// addition.
  std::vector<PictureMask::Part> masks;
  std::size_t own_masks = 0;
  /// Devices that the frame judges, and those that the nearest golden had in addition. Empty: it
  /// was not drawn, or an older version judged it.
  std::optional<RunCoverage> coverage{};
  /// What the picture lacks, which it is judged without: SuiteSession::lacks().
  std::vector<std::string> lacks{};
  std::string key;                        ///< renderer, size, samples
  std::string pixels;                     ///< hash of the drawn picture
  std::string inputs;                     ///< hash of its textures, glyphs and geometry
  std::string session;                    ///< content_sha256 of the log
  std::string decoded{};                  ///< its decoded_sha256; empty without decoded packets
  std::optional<AcceptedPicture> golden;  ///< the nearest accepted one
  std::optional<Picture> drawn, accepted;
  std::optional<Picture> unmasked;  ///< drawn, with the golden's pixels where masks hide
  /// areasPicture of the case's masks where the frame may become a golden; empty without masks.
  std::optional<Picture> areas{};
  std::optional<Picture> thumbnail;     ///< small picture of a fine frame, for the report
  std::shared_ptr<const FrameWhy> why;  ///< set by FrameExplainer for failures
  /// Commands for this frame in a report of several suites.
  std::string run_command{}, approve_command{};

  /// The picture compared with `accepted`; requires `drawn`.
  const Picture& compared() const { return unmasked ? *unmasked : *drawn; }
  std::string page{};  ///< "session.html#t=2": its moment in a page beside the report; or empty
  double render_ms = 0, judge_ms = 0;
};

/// A judged frame as bytes, for another process of the same build; not a file format. The frame,
/// which the receiver has from its own suite, and why it differs are left out.
Bytes wireBytes(const JudgedFrame& judged);
/// Fills in what wireBytes() wrote. damaged when the bytes are invalid; `judged` is then
/// unspecified.
Status readWire(ByteView bytes, JudgedFrame& judged);

}  // namespace rocinante
