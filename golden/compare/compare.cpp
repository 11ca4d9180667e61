#include "golden/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/figure_text.h"
#include "golden/compare/picture_mask.h"
#include "golden/compare/pixel_difference.h"

namespace rocinante {
namespace {

std::int64_t countOver(const LevelCounts& counts, std::size_t limit) {
  std::int64_t sum = 0;
  for (std::size_t level = limit + 1; level < counts.size(); ++level) sum += counts[level];
  return sum;
}

/// Measures two different pictures of one shape.
void measure(const Picture& frame, const Picture& golden, const PixelDifferences& found_levels,
             Comparison& found) {
  const auto& [differences, counts] = found_levels;
  found.differing = countOver(counts, 0);
  found.over_1 = countOver(counts, 1);
  found.over_2 = countOver(counts, 2);
  found.over_8 = countOver(counts, 8);
  found.over_32 = countOver(counts, 32);
  for (int level = 0; level < 256; ++level) {
    if (counts[static_cast<std::size_t>(level)] > 0) found.max = level;
  }
  const auto worst = std::ranges::find(differences, static_cast<std::uint8_t>(found.max));
  const auto place = static_cast<std::size_t>(worst - differences.begin());
  found.worst_x = static_cast<int>(place % static_cast<std::size_t>(frame.width));
  found.worst_y = static_cast<int>(place / static_cast<std::size_t>(frame.width));
  std::copy_n(frame.rgba.data() + place * 4, 4, found.worst_frame.begin());
  std::copy_n(golden.rgba.data() + place * 4, 4, found.worst_golden.begin());
  const WorstTile tile = worstTile(differences, frame.width, frame.height);
  found.worst_tile_mean = tile.mean;
  found.worst_tile_x = tile.x;
  found.worst_tile_y = tile.y;
  found.worst_tile_over = tile.over;
}

/// `judged`: number of pixels that no mask hides.
void decidePixels(const Tolerance& tolerance, std::int64_t judged, Comparison& found) {
  if (found.max > tolerance.level) {
    found.verdict = Verdict::different;
    found.rule =
        fmt::format("largest difference {} > {} ({})", found.max, tolerance.level, tolerance.name);
    return;
  }
  const bool is_rare = found.differing * 100 <= tolerance.percent * judged;
  found.verdict = is_rare ? Verdict::same : Verdict::different;
  found.rule =
      fmt::format("{} of {} pixels differ ({} {} %), by at most {} ({})", found.differing, judged,
                  is_rare ? "<=" : ">", tolerance.percent, found.max, tolerance.name);
}

void decide(const Tolerance& tolerance, std::int64_t judged, Comparison& found) {
  if (tolerance.exact) {
    found.verdict = Verdict::different;
    found.rule =
        countText(static_cast<std::uint64_t>(found.differing), "differing pixel") + " (exact)";
    return;
  }
  if (tolerance.limitsPixels()) {
    decidePixels(tolerance, judged, found);
    if (found.verdict != Verdict::same) return;
  }
  if (found.worst_tile_mean > tolerance.tile_mean) {
    found.verdict = Verdict::different;
    found.rule = fmt::format("worst tile's mean {:.2f} > {:.2f} ({})", found.worst_tile_mean,
                             tolerance.tile_mean, tolerance.name);
    return;
  }
  if (found.worst_tile_over > tolerance.tile_over) {
    found.verdict = Verdict::different;
    found.rule = fmt::format("{} of a tile over 32 > {} ({})",
                             countText(static_cast<std::uint64_t>(found.worst_tile_over), "pixel"),
                             tolerance.tile_over, tolerance.name);
    return;
  }
  found.verdict = Verdict::same;
  if (tolerance.limitsPixels()) return;
  found.rule = fmt::format("worst tile's mean {:.2f} <= {:.2f} and {} <= {} pixels over 32 ({})",
                           found.worst_tile_mean, tolerance.tile_mean, found.worst_tile_over,
                           tolerance.tile_over, tolerance.name);
}

std::size_t rgbaBytes(const Picture& picture) {
  return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4;
}

/// Judges two pictures of one shape, of which `found.masked` pixels were made equal.
void judgePixels(const Picture& frame, const Picture& golden, const Tolerance& tolerance,
                 Comparison& found) {
  const PixelDifferences differences = pixelDifferences(frame, golden);
  if (countOver(differences.counts, 0) == 0) {
    found.verdict = Verdict::same;
    found.rule = "equal pixels";
    return;
  }
  measure(frame, golden, differences, found);
  decide(tolerance, std::int64_t{frame.width} * frame.height - found.masked, found);
}

/// Counts differences beyond 8 bits outside the mask.
void measureFine(const FinePicture& frame, const FinePicture& golden, const PictureMask* mask,
                 Comparison& found) {
  const int width = frame.picture.width;
  for (std::size_t i = 0; i < frame.samples.size(); ++i) {
    if (frame.samples[i] == golden.samples[i]) continue;
    const int pixel = static_cast<int>(i / 4);
    if (mask != nullptr && mask->hides(pixel % width, pixel / width)) continue;
    ++found.fine_differing;
    found.fine_max = std::max(found.fine_max,
                              std::abs(static_cast<double>(frame.samples[i]) - golden.samples[i]));
  }
}

}  // namespace

std::string_view nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return "same";
    case Verdict::different:
      return "different";
    case Verdict::incomparable:
      return "incomparable";
  }
  return "incomparable";
}

Tolerance Tolerance::rounding() {
  Tolerance made{"rounding", false, 255, 256};  // limits pixels, not tiles
  made.level = 1;
  made.percent = 2;
  return made;
}

Result<Tolerance> Tolerance::named(std::string_view name) {
  if (name == "exact") return exactly();
  if (name == "rounding") return rounding();
  if (name == "cpu") return cpu();
  if (name == "loose") return loose();
  return Error{ErrorKind::bad_argument, std::string("a tolerance is ") + kTierNames,
               std::string(name)};
}

Comparison compare(const Picture& frame, const Picture& golden, const Tolerance& tolerance,
                   const PictureMask* mask) {
  Comparison found;
  if (frame.width != golden.width || frame.height != golden.height) {
    found.rule = fmt::format("the frame is {}x{}, the golden {}x{}", frame.width, frame.height,
                             golden.width, golden.height);
    return found;
  }
  if (frame.width <= 0 || frame.height <= 0 || frame.rgba.size() != rgbaBytes(frame) ||
      golden.rgba.size() != rgbaBytes(frame)) {
    found.rule = "the picture has no pixels";
    return found;
  }
  if (mask == nullptr) {
    judgePixels(frame, golden, tolerance, found);
    return found;
  }
  if (mask->width() != frame.width || mask->height() != frame.height) {
    found.rule = fmt::format("the mask is {}x{}, the frame {}x{}", mask->width(), mask->height(),
                             frame.width, frame.height);
    return found;
  }
  found.masked = mask->hiddenPixels();
  if (mask->hidesEverything()) {
    found.rule = "the masks hide every pixel, so nothing would be judged";
    return found;
  }
  judgePixels(mask->applied(frame, golden), golden, tolerance, found);
  return found;
}

Comparison compareFine(const FinePicture& frame, const FinePicture& golden,
                       const Tolerance& tolerance, const PictureMask* mask) {
  Comparison found = compare(frame.picture, golden.picture, tolerance, mask);
  if (found.verdict == Verdict::incomparable) return found;
  const auto refuse = [&](std::string why) {
    found.verdict = Verdict::incomparable;
    found.rule = std::move(why);
    return found;
  };
  if (frame.encoding.bits != golden.encoding.bits ||
      frame.encoding.floating != golden.encoding.floating) {
    return refuse(fmt::format("the frame has {}, the golden {}", frame.encoding.depthText(),
                              golden.encoding.depthText()));
  }
  for (const auto& [whose, picture] : {std::pair("frame", &frame), std::pair("golden", &golden)}) {
    if (picture->not_finite == 0) continue;
    return refuse(fmt::format("{} of the {}'s numbers are NaN or infinite, first at ({}, {})",
                              picture->not_finite, whose, picture->not_finite_x,
                              picture->not_finite_y));
  }
  if (frame.samples.size() != golden.samples.size()) return refuse("the picture has no samples");
  measureFine(frame, golden, mask, found);
  if (tolerance.exact && found.fine_differing > 0) {
    found.verdict = Verdict::different;
    found.rule =
        fmt::format("{} of {}, {} at 8 bits (exact)",
                    countText(static_cast<std::uint64_t>(found.fine_differing), "differing sample"),
                    frame.encoding.depthText(),
                    countText(static_cast<std::uint64_t>(found.differing), "pixel"));
  } else if (found.fine_differing > 0 && found.differing == 0) {
    found.rule = fmt::format("equal pixels at 8 bits ({})", tolerance.name);
  }
  return found;
}

Picture differencePicture(const Picture& frame, const Picture& golden) {
  assert(frame.width == golden.width && frame.height == golden.height);
  Picture shown{frame.width, frame.height, frame.rgba};
  for (std::size_t pixel = 0; pixel < shown.rgba.size(); pixel += 4) {
    std::uint8_t* out = shown.rgba.data() + pixel;
    const int difference = pixelDifference(frame.rgba.data() + pixel, golden.rgba.data() + pixel);
    if (difference == 0) {
      const int grey = (out[0] * 54 + out[1] * 183 + out[2] * 19) / 256;
      const auto dimmed = static_cast<std::uint8_t>(96 + grey / 4);
      out[0] = out[1] = out[2] = dimmed;
    } else {
      out[0] = 255;
      out[1] = static_cast<std::uint8_t>(std::max(0, 220 - difference * 4));
      out[2] = 0;
    }
    out[3] = 255;
  }
  return shown;
}

std::vector<std::string> differenceMap(const Picture& frame, const Picture& golden, int columns) {
  assert(frame.width == golden.width && frame.height == golden.height);
  columns = std::min(columns, frame.width);
  // A character is about twice as high as wide.
  const int rows = std::max(1, frame.height * columns / frame.width / 2);
  std::vector<int> largest(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::vector<std::uint8_t> row(static_cast<std::size_t>(frame.width));
  for (int y = 0; y < frame.height; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * row.size() * 4;
    differenceRow(frame.rgba.data() + first, golden.rgba.data() + first, row);
    const int map_y = std::min(rows - 1, y * rows / frame.height);
    for (int x = 0; x < frame.width; ++x) {
      const int map_x = std::min(columns - 1, x * columns / frame.width);
      int& area = largest[static_cast<std::size_t>(map_y * columns + map_x)];
      area = std::max(area, static_cast<int>(row[static_cast<std::size_t>(x)]));
    }
  }
  std::vector<std::string> lines;
  for (int y = 0; y < rows; ++y) {
    std::string line;
    for (int x = 0; x < columns; ++x) {
      const int difference = largest[static_cast<std::size_t>(y * columns + x)];
      line.push_back(difference == 0    ? ' '
                     : difference <= 2  ? '.'
                     : difference <= 8  ? ':'
                     : difference <= 32 ? '+'
                                        : '#');
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Picture reducedPicture(const Picture& picture, int width) {
  const int factor = std::max(1, (picture.width + width - 1) / width);
  Picture reduced{picture.width / factor, picture.height / factor, {}};
  if (reduced.width == 0 || reduced.height == 0) return picture;
  reduced.rgba.reserve(static_cast<std::size_t>(reduced.width * reduced.height) * 4);
  for (int y = 0; y < reduced.height; ++y) {
    for (int x = 0; x < reduced.width; ++x) {
      for (std::size_t component = 0; component < 4; ++component) {
        int sum = 0;
        for (int row = y * factor; row < (y + 1) * factor; ++row) {
          for (int column = x * factor; column < (x + 1) * factor; ++column) {
            sum +=
                picture
                    .rgba[(static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(column)) *
                              4 +
                          component];
          }
        }
        reduced.rgba.push_back(static_cast<std::uint8_t>(sum / (factor * factor)));
      }
    }
  }
  return reduced;
}

}  // namespace rocinante
