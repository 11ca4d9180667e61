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

/// A caller's 8-bit RGBA pixels, straight alpha; not owned.
struct PictureView {
  int width = 0, height = 0;
  /// Bytes from a row to the one below; negative when the bottom row comes first in memory, as from
  /// glReadPixels (`rgba` then points to the last row in memory).
  std::ptrdiff_t row_bytes = 0;
  const std::uint8_t* rgba = nullptr;  ///< the leftmost pixel of the top row
};

PictureView viewOf(const Picture& picture);
inline PictureView viewOf(const PictureView& view) { return view; }
/// Prints a short text instead of bytes in GoogleTest messages.
void PrintTo(const PictureView& view, std::ostream* out);

/// Folders and mode of a test program's goldens.
struct GoldenPlace {
  std::filesystem::path goldens;  ///< folder of NAME.png
  std::filesystem::path results;  ///< where a failing frame and its difference are written
  bool approve = false;           ///< a failing frame becomes the golden instead

  /// Goldens: ROCINANTE_GOLDEN_DIR from the environment, else `compiled_in` (may be null). Results:
  /// ROCINANTE_GOLDEN_RESULTS, else ./golden-results. approve: ROCINANTE_APPROVE=1. bad_argument
  /// when no folder is given, or when CI is set and goldens would be written.
  static Result<GoldenPlace> fromEnvironment(const char* compiled_in);
};

struct GoldenAnswer {
  bool passes = false;
  /// The rule; for a failing frame also figures, a map and the paths of the written files.
  std::string text;
};

/// Judges `frame` against goldens/NAME.png (docs/goldens-in-your-tests.md). A missing golden fails
/// and writes the frame to the results; goldens are only written with `place.approve`. NAME:
/// letters, digits, `_`, `-` and `.`.
GoldenAnswer checkGolden(const PictureView& frame, std::string_view name,
                         const Tolerance& tolerance, const GoldenPlace& place);

}  // namespace rocinante
