#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "golden/compare/compare.h"
#include "golden/compare/picture_mask.h"

namespace rocinante {

/// Two picture files, judged.
struct FilesComparison {
  Comparison comparison;
  std::optional<Error> unreadable;           ///< of the frame or else the golden: no verdict then
  std::optional<FinePicture> frame, golden;  ///< those that could be read
  std::optional<Picture> masked_frame;       ///< with the golden's pixels where a mask hides
  std::vector<PictureMask::Part> masks;
  /// What a reader of the verdict should know besides: other components, a mask that hides nothing.
  std::vector<std::string> notes;

  /// Both could be read, and are of one shape.
  bool comparable() const { return comparison.verdict != Verdict::incomparable; }
  /// The frame as it was judged; of comparable pictures only.
  const Picture& judged() const { return masked_frame ? *masked_frame : frame->picture; }
};

/// Reads both files at once, one of them in a thread of its own, and judges the first against the
/// second.
FilesComparison compareFiles(const std::filesystem::path& frame,
                             const std::filesystem::path& golden, const Tolerance& tolerance,
                             const std::vector<MaskRectangle>& masks = {});

}  // namespace rocinante
