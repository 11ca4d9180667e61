#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "golden/compare/compare.h"

namespace rocinante {

/// Somebody's 8-bit RGBA pixels, straight alpha; not owned.
struct PictureView {
  int width = 0, height = 0;
  /// From a row to the one below it; negative where the bottom row comes first in memory, as
  /// glReadPixels gives them (`rgba` then points to the last row in memory).
  std::ptrdiff_t row_bytes = 0;
  const std::uint8_t* rgba = nullptr;  ///< the leftmost pixel of the top row
};

PictureView viewOf(const Picture& picture);
inline PictureView viewOf(const PictureView& view) { return view; }
/// What GoogleTest prints of one, in place of its bytes.
void PrintTo(const PictureView& view, std::ostream* out);

/// Where the goldens of a test program are and what may be done with them.
struct GoldenPlace {
  std::filesystem::path goldens;  ///< folder of NAME.png
  std::filesystem::path results;  ///< where a failing frame and its difference are written
  bool approve = false;           ///< a frame that would fail becomes the golden instead

  /// Goldens: ROCINANTE_GOLDEN_DIR from the environment, else `compiled_in` (may be null). Results:
  /// ROCINANTE_GOLDEN_RESULTS, else ./golden-results. approve: ROCINANTE_APPROVE=1. bad_argument
  /// when no folder is named, or where CI is set and goldens would be written.
  static Result<GoldenPlace> fromEnvironment(const char* compiled_in);
};

struct GoldenAnswer {
  bool passes = false;
  /// The rule, and of a frame that fails the figures, a map and the paths of what was written.
  std::string text;
};

/// Judges `frame` against goldens/NAME.png (docs/goldens-in-your-tests.md). A missing golden fails
/// and leaves the frame; only `place.approve` writes one. NAME: letters, digits, `_`, `-` and `.`.
GoldenAnswer checkGolden(const PictureView& frame, std::string_view name,
                         const Tolerance& tolerance, const GoldenPlace& place);

}  // namespace rocinante
