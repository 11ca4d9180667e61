#include "golden/compare/comparison_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/figure_text.h"

namespace rocinante {

std::string differenceText(const Comparison& found, const Picture& judged, const Picture& golden) {
  if (found.differing == 0) return "";
  const std::int64_t pixels = std::int64_t{golden.width} * golden.height;
  const auto share = [&](std::int64_t count) {
    return static_cast<double>(count) / static_cast<double>(pixels) * 100;
  };
  std::string text = fmt::format("differing pixels: {} of {} ({:.3f} %)\n", found.differing, pixels,
                                 share(found.differing));
  text += fmt::format("over 1/2/8/32: {}/{}/{}/{} ({:.3f}/{:.3f}/{:.3f}/{:.3f} %)\n", found.over_1,
                      found.over_2, found.over_8, found.over_32, share(found.over_1),
                      share(found.over_2), share(found.over_8), share(found.over_32));
  text += fmt::format("largest difference: {} at ({}, {}): rgba {} against {}\n", found.max,
                      found.worst_x, found.worst_y, fmt::join(found.worst_frame, " "),
                      fmt::join(found.worst_golden, " "));
  text += fmt::format("worst 16x16 tile: mean {:.2f} at ({}, {}); at most {} of a tile over 32\n",
                      found.worst_tile_mean, found.worst_tile_x, found.worst_tile_y,
                      countText(static_cast<std::uint64_t>(found.worst_tile_over), "pixel"));
  for (const std::string& line : differenceMap(judged, golden)) {
    text += fmt::format("    |{}|\n", line);
  }
  return text;
}

}  // namespace rocinante
