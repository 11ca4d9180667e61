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
  std::optional<Error> unreadable;           ///< the frame's, else the golden's
  std::optional<FinePicture> frame, golden;  ///< those that could be read
  std::optional<Picture> masked_frame;       ///< with the golden's pixels where masked
  std::vector<PictureMask::Part> masks;
  /// Notes beside the verdict: different components or orientations, a mask that hides
  /// nothing.
  std::vector<std::string> notes;

  /// True when both were read and have one shape.
  bool comparable() const { return comparison.verdict != Verdict::incomparable; }
  /// The frame as judged; requires comparable().
  const Picture& judged() const { return masked_frame ? *masked_frame : frame->picture; }
};

/// Reads both files in parallel, one in its own thread, and compares the first with the second.
FilesComparison compareFiles(const std::filesystem::path& frame,
                             const std::filesystem::path& golden, const Tolerance& tolerance,
                             const std::vector<MaskRectangle>& masks = {});

}  // namespace rocinante
