#include "golden/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/count_text.h"
#include "golden/picture_mask.h"
#include "golden/pixel_difference.h"

namespace rocinante {
namespace {

std::int64_t countOver(const LevelCounts& counts, std::size_t limit) {
  std::int64_t sum = 0;
  for (std::size_t level = limit + 1; level < counts.size(); ++level) sum += counts[level];
  return sum;
}

/// All figures of two pictures of one shape that are not the same.
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

void decide(const Tolerance& tolerance, Comparison& found) {
  if (tolerance.exact) {
    found.verdict = Verdict::different;
    found.rule = countText(found.differing, "differing pixel") + " (exact)";
    return;
  }
  if (found.worst_tile_mean > tolerance.tile_mean) {
    found.verdict = Verdict::different;
    found.rule = fmt::format("worst tile's mean {:.2f} > {:.2f} ({})", found.worst_tile_mean,
                             tolerance.tile_mean, tolerance.name);
    return;
  }
  if (found.worst_tile_over > tolerance.tile_over) {
    found.verdict = Verdict::different;
    found.rule =
        fmt::format("{} of a tile over 32 > {} ({})", countText(found.worst_tile_over, "pixel"),
                    tolerance.tile_over, tolerance.name);
    return;
  }
  found.verdict = Verdict::same;
  found.rule = fmt::format("worst tile's mean {:.2f} <= {:.2f} and {} <= {} pixels over 32 ({})",
                           found.worst_tile_mean, tolerance.tile_mean, found.worst_tile_over,
                           tolerance.tile_over, tolerance.name);
}

std::size_t rgbaBytes(const Picture& picture) {
  return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4;
}

/// Counts what differs beyond 8 bits, outside the mask.
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

Result<Tolerance> Tolerance::named(std::string_view name) {
  if (name == "exact") return exactly();
  if (name == "cpu") return cpu();
  if (name == "loose") return loose();
  return Error{ErrorKind::bad_argument, "a tolerance is exact, cpu or loose", std::string(name)};
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
    found.rule = "a picture without pixels";
    return found;
  }
  if (mask != nullptr) {
    if (mask->width() != frame.width || mask->height() != frame.height) {
      found.rule = fmt::format("the mask is {}x{}, the frame {}x{}", mask->width(), mask->height(),
                               frame.width, frame.height);
      return found;
    }
    found.masked = mask->hiddenPixels();
    if (mask->hidesEverything()) {
      found.rule = "the masks hide every pixel: nothing would be judged";
      return found;
    }
    const std::int64_t masked = found.masked;
    found = compare(mask->applied(frame, golden), golden, tolerance);
    found.masked = masked;
    return found;
  }
  const PixelDifferences differences = pixelDifferences(frame, golden);
  if (countOver(differences.counts, 0) == 0) {
    found.verdict = Verdict::same;
    found.rule = "equal pixels";
    return found;
  }
  measure(frame, golden, differences, found);
  decide(tolerance, found);
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
  if (frame.samples.size() != golden.samples.size()) return refuse("a picture without samples");
  measureFine(frame, golden, mask, found);
  if (tolerance.exact && found.fine_differing > 0) {
    found.verdict = Verdict::different;
    found.rule = fmt::format("{} of {}, {} at 8 bits (exact)",
                             countText(found.fine_differing, "differing sample"),
                             frame.encoding.depthText(), countText(found.differing, "pixel"));
  } else if (found.fine_differing > 0 && found.differing == 0) {
    found.rule = fmt::format("equal pixels at 8 bits ({})", tolerance.name);
  }
  return found;
}

}  // namespace rocinante
