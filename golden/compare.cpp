#include "golden/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>

namespace rocinante {
namespace {

constexpr int kTile = 16;
constexpr int kStride = 8;
constexpr int kOver = 32;

std::size_t pixelIndex(const Picture& picture, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
         static_cast<std::size_t>(x);
}

int pixelDifference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int component = 0; component < 4; ++component) {
    largest = std::max(largest, std::abs(a[component] - b[component]));
  }
  return largest;
}

/// The largest component difference of each pixel, in one row.
void differenceRow(const Picture& a, const Picture& b, int y, std::uint8_t* row) {
  const std::uint8_t* pixel_a = a.rgba.data() + pixelIndex(a, 0, y) * 4;
  const std::uint8_t* pixel_b = b.rgba.data() + pixelIndex(b, 0, y) * 4;
  for (int x = 0; x < a.width; ++x) {
    row[x] = static_cast<std::uint8_t>(pixelDifference(pixel_a + x * 4, pixel_b + x * 4));
  }
}

/// Where tiles begin along one side: every 8 pixels, and flush to the far edge.
std::vector<int> tileStarts(int length) {
  std::vector<int> starts;
  for (int start = 0; start + kTile <= length; start += kStride) starts.push_back(start);
  const int flush = std::max(0, length - kTile);
  if (starts.empty() || starts.back() != flush) starts.push_back(flush);
  return starts;
}

/// Sums over columns of the rows of one band of tiles, so that a tile costs 16 additions.
struct ColumnSums {
  std::vector<std::uint32_t> difference;
  std::vector<std::uint32_t> over;
};

void findWorstTile(const std::vector<std::uint8_t>& differences, int width, int height,
                   Comparison& found) {
  const std::vector<int> columns = tileStarts(width);
  const int tile_width = std::min(kTile, width);
  const int tile_height = std::min(kTile, height);
  const auto size = static_cast<std::size_t>(width);
  ColumnSums sums{std::vector<std::uint32_t>(size), std::vector<std::uint32_t>(size)};
  for (const int top : tileStarts(height)) {
    std::ranges::fill(sums.difference, 0U);
    std::ranges::fill(sums.over, 0U);
    for (int y = top; y < top + tile_height; ++y) {
      const std::uint8_t* row = differences.data() + static_cast<std::size_t>(y) * size;
      for (std::size_t x = 0; x < size; ++x) {
        sums.difference[x] += row[x];
        sums.over[x] += row[x] > kOver ? 1U : 0U;
      }
    }
    for (const int left : columns) {
      std::uint32_t difference = 0;
      std::uint32_t over = 0;
      for (int x = left; x < left + tile_width; ++x) {
        difference += sums.difference[static_cast<std::size_t>(x)];
        over += sums.over[static_cast<std::size_t>(x)];
      }
      found.worst_tile_mean = std::max(found.worst_tile_mean,
                                       difference / static_cast<double>(tile_width * tile_height));
      found.worst_tile_over = std::max(found.worst_tile_over, static_cast<std::int64_t>(over));
    }
  }
}

void decide(const Tolerance& tolerance, Comparison& found) {
  if (tolerance.exact) {
    found.verdict = Verdict::different;
    found.rule = fmt::format("{} differing pixels (exact)", found.differing);
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
    found.rule = fmt::format("{} pixels of a tile over 32 > {} ({})", found.worst_tile_over,
                             tolerance.tile_over, tolerance.name);
    return;
  }
  found.verdict = Verdict::same;
  found.rule = fmt::format("worst tile's mean {:.2f} <= {:.2f} and {} <= {} pixels over 32 ({})",
                           found.worst_tile_mean, tolerance.tile_mean, found.worst_tile_over,
                           tolerance.tile_over, tolerance.name);
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

Comparison compare(const Picture& frame, const Picture& golden, const Tolerance& tolerance) {
  Comparison found;
  if (frame.width != golden.width || frame.height != golden.height) {
    found.rule = fmt::format("the frame is {}x{}, the golden {}x{}", frame.width, frame.height,
                             golden.width, golden.height);
    return found;
  }
  const std::size_t bytes =
      static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 4;
  if (bytes == 0 || frame.rgba.size() != bytes || golden.rgba.size() != bytes) {
    found.rule = "a picture without pixels";
    return found;
  }
  if (std::memcmp(frame.rgba.data(), golden.rgba.data(), bytes) == 0) {
    found.verdict = Verdict::same;
    found.rule = "equal pixels";
    return found;
  }

  std::vector<std::uint8_t> differences(bytes / 4);
  for (int y = 0; y < frame.height; ++y) {
    std::uint8_t* row = differences.data() + pixelIndex(frame, 0, y);
    differenceRow(frame, golden, y, row);
    for (int x = 0; x < frame.width; ++x) {
      const int difference = row[x];
      if (difference == 0) continue;
      ++found.differing;
      found.over_1 += difference > 1 ? 1 : 0;
      found.over_2 += difference > 2 ? 1 : 0;
      found.over_8 += difference > 8 ? 1 : 0;
      found.over_32 += difference > kOver ? 1 : 0;
      if (difference > found.max) {
        found.max = difference;
        found.worst_x = x;
        found.worst_y = y;
      }
    }
  }
  const std::size_t worst = pixelIndex(frame, found.worst_x, found.worst_y) * 4;
  std::copy_n(frame.rgba.begin() + static_cast<std::ptrdiff_t>(worst), 4,
              found.worst_frame.begin());
  std::copy_n(golden.rgba.begin() + static_cast<std::ptrdiff_t>(worst), 4,
              found.worst_golden.begin());
  findWorstTile(differences, frame.width, frame.height, found);
  decide(tolerance, found);
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
    differenceRow(frame, golden, y, row.data());
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
            sum += picture.rgba[pixelIndex(picture, column, row) * 4 + component];
          }
        }
        reduced.rgba.push_back(static_cast<std::uint8_t>(sum / (factor * factor)));
      }
    }
  }
  return reduced;
}

}  // namespace rocinante
