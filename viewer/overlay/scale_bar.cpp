#include "viewer/overlay/scale_bar.h"

#include <array>
#include <string_view>

namespace rocinante {
namespace {

struct BarUnit {
  std::string_view name;
  double metres;
};
constexpr std::array kUnits{BarUnit{"nm", 1e-9}, BarUnit{"µm", 1e-6}, BarUnit{"mm", 1e-3},
                            BarUnit{"m", 1}, BarUnit{"km", 1e3}};
constexpr std::array kSteps{1, 2, 5, 10, 20, 50, 100, 200, 500};

}  // namespace

std::optional<ScaleBar> scaleBar(double metres_per_pixel, double longest_px) {
  if (!(metres_per_pixel > 0) || !(longest_px > 0)) return std::nullopt;
  std::optional<ScaleBar> best;
  const auto consider = [&](int count, const BarUnit& unit) {
    const double metres = count * unit.metres;
    const double pixels = metres / metres_per_pixel;
    if (pixels > longest_px) return;
    best = ScaleBar{metres, pixels, std::to_string(count) + " " + std::string(unit.name)};
  };
  for (const BarUnit& unit : kUnits) {
    for (const int step : kSteps) consider(step, unit);
  }
  for (const int thousands : {1, 10, 100, 1000}) {
    for (const int step : {1, 2, 5}) consider(step * thousands * 1000, kUnits.back());
  }
  // Even the longest is too short to be useful or to be drawn.
  if (!best || best->pixels < longest_px / 10) return std::nullopt;
  return best;
}

}  // namespace rocinante
