#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/picture.h"

namespace rocinante {

class PictureMask;

/// How far a frame may differ from its golden and still count as the same (docs/golden-suites.md,
/// "Tolerances"). Limits are inclusive.
struct Tolerance {
  std::string name = "exact";
  bool exact = true;           ///< equal pixels; the limits below are ignored
  double tile_mean = 0;        ///< largest mean difference of a 16x16 tile, 0 to 255
  std::int64_t tile_over = 0;  ///< most pixels of a tile that may differ by more than 32
  int level = 255;             ///< largest difference of any pixel
  int percent = 100;           ///< most judged pixels that may differ at all, in percent

  static Tolerance exactly() { return {}; }
  /// For pictures rounded differently by another version of the renderer: components differ by at
  /// most 1, in at most 2 % of the pixels.
  static Tolerance rounding();
  /// For another CPU class without the pinned CPU features.
  static Tolerance cpu() { return {"cpu", false, 4.0, 2}; }
  static Tolerance loose() { return {"loose", false, 6.0, 16}; }
  /// "exact", "rounding", "cpu" or "loose".
  static Result<Tolerance> named(std::string_view name);

  /// `rounding` limits pixels, the others tiles.
  bool limitsPixels() const { return !exact && (level < 255 || percent < 100); }
};

/// "exact, rounding, cpu or loose", for help and messages about unknown names.
inline constexpr char kTierNames[] = "exact, rounding, cpu or loose";

enum class Verdict : std::uint8_t {
  same,          ///< within the tolerance
  different,     ///< comparable, and outside the tolerance
  incomparable,  ///< different shapes, or nothing to compare with
};
std::string_view nameOf(Verdict verdict);

/// The measured differences and the rule that decided. The difference of two pixels is the largest
/// of |a - b| over R, G, B and A, from 0 to 255.
struct Comparison {
  Verdict verdict = Verdict::incomparable;
  std::string rule;              ///< "equal pixels", "worst tile's mean 5.31 > 4.00 (cpu)", ...
  int max = 0;                   ///< largest difference
  int worst_x = 0, worst_y = 0;  ///< where it is; origin top left
  std::array<std::uint8_t, 4> worst_frame{}, worst_golden{};  ///< RGBA there
  double worst_tile_mean = 0;
  int worst_tile_x = 0, worst_tile_y = 0;  ///< upper left pixel of the first tile with that mean
  std::int64_t worst_tile_over = 0;        ///< most pixels over 32 in any one tile
  /// How many pixels differ by at least 1, and by more than 1, 2, 8 and 32.
  std::int64_t differing = 0;
  std::int64_t over_1 = 0, over_2 = 0, over_8 = 0, over_32 = 0;
  std::int64_t masked = 0;  ///< pixels hidden by masks
  /// Beyond 8 bits: the number of differing samples and their largest difference, in the file's
  /// values.
  std::int64_t fine_differing = 0;
  double fine_max = 0;
};

/// Compares a frame with its golden. Shape first: a cropped frame never passes. Pixels that the
/// mask hides count as equal. A mask of another size or one that hides everything makes the
/// pictures incomparable.
Comparison compare(const Picture& frame, const Picture& golden, const Tolerance& tolerance,
                   const PictureMask* mask = nullptr);

/// The same for pictures that may be deeper than 8 bits. Shape first, then depth, then finiteness:
/// a picture with NaN or an infinite sample never passes, not even against itself, masked or not.
/// Tolerances apply to 8 bits; only equal samples are exactly the same.
Comparison compareFine(const FinePicture& frame, const FinePicture& golden,
                       const Tolerance& tolerance, const PictureMask* mask = nullptr);

/// Picture of the differences of two pictures of one shape: the frame in dimmed grey, differing
/// pixels from yellow (slight) to red.
Picture differencePicture(const Picture& frame, const Picture& golden);

/// The same as lines of text: one character per area, ` .:+#` by its largest difference.
std::vector<std::string> differenceMap(const Picture& frame, const Picture& golden,
                                       int columns = 48);

/// `picture` reduced by averaging to a whole fraction of its size, at most `width` wide.
Picture reducedPicture(const Picture& picture, int width);

}  // namespace rocinante
