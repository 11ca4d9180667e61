#include "core/check/reports/time_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 8> kBlocks = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<std::string_view, 8> kAscii = {".", ":", "-", "=", "+", "*", "%", "#"};

}  // namespace

std::string timeStrip(const TimeHistogram& when, LogTime origin, Nanoseconds duration,
                      std::size_t width, bool unicode) {
  if (when.counts().empty() || duration.count() <= 0 || width == 0) return "";
  // In cells of the strip. A bin wider than a cell is spread over all cells that it covers.
  const double cell = static_cast<double>(duration.count()) / static_cast<double>(width);
  const double bin_width = static_cast<double>(when.width().count()) / cell;
  const double start = static_cast<double>((when.start() - origin).count()) / cell;
  const double last_cell = static_cast<double>(width) - 1;
  std::vector<double> cells(width, 0.0);
  for (std::size_t bin = 0; bin < when.counts().size(); ++bin) {
    if (when.counts()[bin] == 0) continue;
    const double from = start + static_cast<double>(bin) * bin_width;
    const auto first = static_cast<std::size_t>(std::clamp(std::floor(from), 0.0, last_cell));
    const auto last = static_cast<std::size_t>(
        std::clamp(std::ceil(from + bin_width) - 1, static_cast<double>(first), last_cell));
    const double share = when.counts()[bin] / static_cast<double>(last - first + 1);
    for (std::size_t i = first; i <= last; ++i) cells[i] += share;
  }
  const double most = *std::max_element(cells.begin(), cells.end());
  const auto& levels = unicode ? kBlocks : kAscii;
  std::string strip;
  for (const double count : cells) {
    const auto level = static_cast<std::size_t>(std::ceil(count / most * 8));
    strip += level == 0 ? std::string_view(" ") : levels[std::min<std::size_t>(level, 8) - 1];
  }
  return strip;
}

}  // namespace rocinante
