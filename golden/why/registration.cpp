#include "golden/why/registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

namespace rocinante {
namespace {

/// More pixels cost time and do not improve the result.
constexpr std::size_t kMaxSamples = 3000;
constexpr int kNear = 3;
constexpr int kRim = 2;
/// An eighth of full scale in all three components counts as no fit: a shaded surface differs less
/// from itself.
constexpr double kFullCost = 3 * 32.0;

struct Pixel {
  int x = 0, y = 0;
};

std::size_t pixelAt(const Picture& picture, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
         static_cast<std::size_t>(x);
}

bool holds(const Picture& picture, int x, int y) {
  return x >= 0 && y >= 0 && x < picture.width && y < picture.height;
}

double colorCost(const Picture& a, std::size_t at_a, const Picture& b, std::size_t at_b) {
  int sum = 0;
  for (std::size_t component = 0; component < 3; ++component) {
    sum += std::abs(a.rgba[at_a * 4 + component] - b.rgba[at_b * 4 + component]);
  }
  return std::min(1.0, sum / kFullCost);
}

/// Evenly spread pixels of a region.
std::vector<Pixel> samplesOf(const Region& region, const Picture& picture) {
  std::vector<Pixel> all;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (region.inside[pixelAt(picture, x, y)] != 0) all.push_back({x, y});
    }
  }
  if (all.size() <= kMaxSamples) return all;
  std::vector<Pixel> some;
  for (std::size_t i = 0; i < kMaxSamples; ++i) {
    some.push_back(all[i * all.size() / kMaxSamples]);
  }
  return some;
}

using CostOf = std::function<double(int right, int down)>;

/// Whole-pixel descent from `start` with cached costs, then an interpolated minimum in x and y.
class ShiftSearch {
 public:
  explicit ShiftSearch(CostOf cost) : cost_(std::move(cost)) {}

  double cost(int right, int down) {
    const auto [found, is_new] = known_.try_emplace({right, down}, 0.0);
    if (is_new) found->second = cost_(right, down);
    return found->second;
  }

  void tryAround(int right, int down, int window, int step) {
    for (int y = -window; y <= window; y += step) {
      for (int x = -window; x <= window; x += step) consider(right + x, down + y);
    }
  }

  void descend() {
    for (int steps = 0; steps < 64; ++steps) {
      const auto [right, down] = best_;
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) consider(right + x, down + y);
      }
      if (best_ == std::pair(right, down)) return;
    }
  }

  Shift shift() {
    const auto [right, down] = best_;
    Shift found{static_cast<double>(right), static_cast<double>(down), cost(right, down),
                cost(0, 0)};
    found.right += vertex(cost(right - 1, down), found.cost, cost(right + 1, down));
    found.down += vertex(cost(right, down - 1), found.cost, cost(right, down + 1));
    return found;
  }

 private:
  void consider(int right, int down) {
    const double candidate = cost(right, down);
    if (candidate < cost(best_.first, best_.second)) best_ = {right, down};
  }
  /// Vertex of the two lines of equal slope through three values: costs are sums of |a - b|, so
  /// their minimum is a corner, not a parabola.
  static double vertex(double before, double middle, double after) {
    const double steepest = std::max(before, after) - middle;
    return steepest > 0 ? (before - after) / (2 * steepest) : 0;
  }

  CostOf cost_;
  std::map<std::pair<int, int>, double> known_;
  std::pair<int, int> best_{0, 0};
};

}  // namespace

Region regionOf(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t id) {
  Region region;
  region.inside.resize(ids.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x);
      if (ids[at] != id) continue;
      region.inside[at] = 1;
      ++region.pixels;
      region.x += x;
      region.y += y;
      region.touches_edge |= x == 0 || y == 0 || x == width - 1 || y == height - 1;
    }
  }
  if (region.pixels > 0) {
    region.x /= static_cast<double>(region.pixels);
    region.y /= static_cast<double>(region.pixels);
  }
  return region;
}

std::optional<Shift> registerRegions(const Picture& from, const Region& from_region,
                                     const Picture& to, const Region& to_region) {
  if (from_region.pixels == 0 || to_region.pixels == 0) return std::nullopt;
  const std::vector<Pixel> in_from = samplesOf(from_region, from);
  const std::vector<Pixel> in_to = samplesOf(to_region, to);
  const auto costOf = [&](int right, int down) {
    double cost = 0;
    for (const Pixel& pixel : in_from) {
      const int x = pixel.x + right;
      const int y = pixel.y + down;
      const bool fits = holds(to, x, y) && to_region.inside[pixelAt(to, x, y)] != 0;
      cost += fits ? colorCost(from, pixelAt(from, pixel.x, pixel.y), to, pixelAt(to, x, y)) : 1.0;
    }
    for (const Pixel& pixel : in_to) {
      const int x = pixel.x - right;
      const int y = pixel.y - down;
      const bool fits = holds(from, x, y) && from_region.inside[pixelAt(from, x, y)] != 0;
      cost += fits ? colorCost(from, pixelAt(from, x, y), to, pixelAt(to, pixel.x, pixel.y)) : 1.0;
    }
    return cost / static_cast<double>(in_from.size() + in_to.size());
  };
  ShiftSearch search(costOf);
  search.tryAround(static_cast<int>(std::lround(to_region.x - from_region.x)),
                   static_cast<int>(std::lround(to_region.y - from_region.y)), kNear, 1);
  search.tryAround(0, 0, 1, 1);
  search.descend();
  Shift shift = search.shift();
  // For complete outlines of one size the centroids give fractions better than the costs.
  const double right = to_region.x - from_region.x;
  const double down = to_region.y - from_region.y;
  const double larger = static_cast<double>(std::max(from_region.pixels, to_region.pixels));
  const bool is_whole =
      !from_region.touches_edge && !to_region.touches_edge &&
      static_cast<double>(std::abs(from_region.pixels - to_region.pixels)) <= 0.02 * larger + 1;
  if (is_whole && std::abs(right - shift.right) < 1 && std::abs(down - shift.down) < 1) {
    shift.right = right;
    shift.down = down;
  }
  return shift;
}

namespace {

/// The cost of placing `samples` of one picture on another, with bilinear interpolation for
/// fractional shifts.
double costBetween(const Picture& from, const std::vector<Pixel>& samples, const Picture& to,
                   double right, double down) {
  const int whole_right = static_cast<int>(std::floor(right));
  const int whole_down = static_cast<int>(std::floor(down));
  const double part_x = right - whole_right;
  const double part_y = down - whole_down;
  const std::array<double, 4> weights = {(1 - part_x) * (1 - part_y), part_x * (1 - part_y),
                                         (1 - part_x) * part_y, part_x * part_y};
  double cost = 0;
  for (const Pixel& pixel : samples) {
    const int x = pixel.x + whole_right;
    const int y = pixel.y + whole_down;
    if (!holds(to, x, y) || !holds(to, x + 1, y + 1)) {
      cost += 1;
      continue;
    }
    const std::array<std::size_t, 4> corners = {pixelAt(to, x, y), pixelAt(to, x + 1, y),
                                                pixelAt(to, x, y + 1), pixelAt(to, x + 1, y + 1)};
    const std::size_t at = pixelAt(from, pixel.x, pixel.y);
    double sum = 0;
    for (std::size_t component = 0; component < 3; ++component) {
      double value = 0;
      for (std::size_t i = 0; i < 4; ++i) value += weights[i] * to.rgba[corners[i] * 4 + component];
      sum += std::abs(value - from.rgba[at * 4 + component]);
    }
    cost += std::min(1.0, sum / kFullCost);
  }
  return cost / static_cast<double>(samples.size());
}

/// Refines a whole-pixel shift by halves of a pixel, quarters and so on.
void refine(const Picture& from, const std::vector<Pixel>& samples, const Picture& to,
            Shift& shift) {
  shift.cost = costBetween(from, samples, to, shift.right, shift.down);
  for (double step = 0.5; step > 0.05; step /= 2) {
    const Shift middle = shift;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const double right = middle.right + x * step;
        const double down = middle.down + y * step;
        const double cost = costBetween(from, samples, to, right, down);
        if (cost < shift.cost) shift = {right, down, cost, shift.cost_unmoved};
      }
    }
  }
}

}  // namespace

Picture smoothed(const Picture& picture) {
  Picture made = picture;
  for (int y = 1; y + 1 < picture.height; ++y) {
    for (int x = 1; x + 1 < picture.width; ++x) {
      for (std::size_t component = 0; component < 3; ++component) {
        const auto row = [&](int line) {
          const std::uint8_t* at = &picture.rgba[pixelAt(picture, x, line) * 4 + component];
          return at[-4] + 2 * at[0] + at[4];
        };
        made.rgba[pixelAt(picture, x, y) * 4 + component] =
            static_cast<std::uint8_t>((row(y - 1) + 2 * row(y) + row(y + 1) + 8) / 16);
      }
    }
  }
  return made;
}

std::optional<Shift> findRegion(const Picture& from, const Region& region, const Picture& to,
                                int window) {
  if (region.pixels == 0) return std::nullopt;
  Region rimmed = region;
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      if (region.inside[pixelAt(from, x, y)] == 0) continue;
      for (int down = -kRim; down <= kRim; ++down) {
        for (int right = -kRim; right <= kRim; ++right) {
          if (holds(from, x + right, y + down)) {
            rimmed.inside[pixelAt(from, x + right, y + down)] = 1;
          }
        }
      }
    }
  }
  const std::vector<Pixel> samples = samplesOf(rimmed, from);
  const auto costOf = [&](int right, int down) {
    double cost = 0;
    for (const Pixel& pixel : samples) {
      const int x = pixel.x + right;
      const int y = pixel.y + down;
      cost += holds(to, x, y)
                  ? colorCost(from, pixelAt(from, pixel.x, pixel.y), to, pixelAt(to, x, y))
                  : 1.0;
    }
    return cost / static_cast<double>(samples.size());
  };
  ShiftSearch search(costOf);
  search.tryAround(0, 0, window, 2);
  search.descend();
  Shift shift = search.shift();
  shift.right = std::round(shift.right);
  shift.down = std::round(shift.down);
  refine(from, samples, to, shift);
  return shift;
}

}  // namespace rocinante
