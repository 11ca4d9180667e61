#include "golden/compare/pixel_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <thread>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace rocinante {
namespace {

constexpr int kTile = 16;
constexpr int kStride = 8;  // half a tile: a fault on a tile's edge is inside the next
constexpr int kOver = 32;

std::size_t indexOf(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

/// Sums of a tile or of a quarter of one.
struct TileSums {
  std::int32_t difference = 0;
  std::int32_t over = 0;

  TileSums& operator+=(const TileSums& other) {
    difference += other.difference;
    over += other.over;
    return *this;
  }
};

TileSums sumsOf(std::span<const std::uint8_t> differences, int picture_width, int left, int top,
                int width, int height) {
  TileSums sums;
  for (int y = top; y < top + height; ++y) {
    const std::uint8_t* row = differences.data() + indexOf(left, y, picture_width);
    for (int x = 0; x < width; ++x) {
      sums.difference += row[x];
      sums.over += row[x] > kOver ? 1 : 0;
    }
  }
  return sums;
}

#ifdef __SSE2__
/// |a - b| of each byte.
__m128i absoluteDifference(const std::uint8_t* a, const std::uint8_t* b) {
  const __m128i left = _mm_loadu_si128(reinterpret_cast<const __m128i*>(a));
  const __m128i right = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b));
  return _mm_or_si128(_mm_subs_epu8(left, right), _mm_subs_epu8(right, left));
}

/// The largest of the four bytes of each 32-bit lane, in its lowest byte; the others are zero.
__m128i largestOfFour(__m128i bytes) {
  __m128i largest = _mm_max_epu8(bytes, _mm_srli_epi32(bytes, 8));
  largest = _mm_max_epu8(largest, _mm_srli_epi32(largest, 16));
  return _mm_and_si128(largest, _mm_set1_epi32(0xFF));
}

/// Adds eight rows of sixteen pixels to their two tile quarters.
void addQuarters(const std::uint8_t* first, std::size_t row_bytes, TileSums* quarters) {
  const __m128i zero = _mm_setzero_si128();
  const __m128i limit = _mm_set1_epi8(kOver);
  const __m128i one = _mm_set1_epi8(1);
  __m128i difference = zero;
  __m128i over = zero;
  for (std::size_t row = 0; row < kStride; ++row) {
    const __m128i pixels =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(first + row * row_bytes));
    difference = _mm_add_epi32(difference, _mm_sad_epu8(pixels, zero));
    over = _mm_add_epi32(over, _mm_sad_epu8(_mm_min_epu8(_mm_subs_epu8(pixels, limit), one), zero));
  }
  quarters[0] += {_mm_cvtsi128_si32(difference), _mm_cvtsi128_si32(over)};
  quarters[1] += {_mm_cvtsi128_si32(_mm_srli_si128(difference, 8)),
                  _mm_cvtsi128_si32(_mm_srli_si128(over, 8))};
}
#endif

/// The sums of one row of 8x8 tile quarters that begins at pixel row `top`.
void sumQuarters(std::span<const std::uint8_t> differences, int width, int top,
                 std::vector<TileSums>& quarters) {
  std::ranges::fill(quarters, TileSums{});
  std::size_t done = 0;
#ifdef __SSE2__
  const std::uint8_t* first = differences.data() + indexOf(0, top, width);
  for (; done + 2 <= quarters.size(); done += 2) {
    addQuarters(first + done * kStride, static_cast<std::size_t>(width), &quarters[done]);
  }
#endif
  for (; done < quarters.size(); ++done) {
    quarters[done] =
        sumsOf(differences, width, static_cast<int>(done) * kStride, top, kStride, kStride);
  }
}

/// From this many pixels a second thread saves more than it costs.
constexpr std::size_t kLargePicture = 1'000'000;

void countLevels(std::span<const std::uint8_t> levels, LevelCounts& counts) {
  std::size_t i = 0;
  for (; i + 8 <= levels.size(); i += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, levels.data() + i, sizeof eight);
    if (eight == 0) {  // most pixels are equal
      counts[0] += 8;
      continue;
    }
    for (std::size_t j = 0; j < 8; ++j) ++counts[levels[i + j]];
  }
  for (; i < levels.size(); ++i) ++counts[levels[i]];
}

/// Pixels [first, end) of `found.levels`, counted in `counts`.
void findDifferences(const Picture& a, const Picture& b, std::size_t first, std::size_t end,
                     PixelDifferences& found, LevelCounts& counts) {
  constexpr std::size_t kPiece = 4096;  // still cached when its levels are counted
  for (std::size_t at = first; at < end; at += kPiece) {
    const std::span<std::uint8_t> levels(found.levels.data() + at, std::min(kPiece, end - at));
    differenceRow(a.rgba.data() + at * 4, b.rgba.data() + at * 4, levels);
    countLevels(levels, counts);
  }
}

}  // namespace

int pixelDifference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int component = 0; component < 4; ++component) {
    largest = std::max(largest, std::abs(a[component] - b[component]));
  }
  return largest;
}

void differenceRowPlain(const std::uint8_t* a, const std::uint8_t* b, std::span<std::uint8_t> out) {
  for (std::size_t x = 0; x < out.size(); ++x) {
    out[x] = static_cast<std::uint8_t>(pixelDifference(a + x * 4, b + x * 4));
  }
}

void differenceRow(const std::uint8_t* a, const std::uint8_t* b, std::span<std::uint8_t> out) {
  std::size_t done = 0;
#ifdef __SSE2__
  for (; done + 16 <= out.size(); done += 16) {
    const std::uint8_t* from_a = a + done * 4;
    const std::uint8_t* from_b = b + done * 4;
    const __m128i low =
        _mm_packs_epi32(largestOfFour(absoluteDifference(from_a, from_b)),
                        largestOfFour(absoluteDifference(from_a + 16, from_b + 16)));
    const __m128i high =
        _mm_packs_epi32(largestOfFour(absoluteDifference(from_a + 32, from_b + 32)),
                        largestOfFour(absoluteDifference(from_a + 48, from_b + 48)));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out.data() + done), _mm_packus_epi16(low, high));
  }
#endif
  differenceRowPlain(a + done * 4, b + done * 4, out.subspan(done));
}

PixelDifferences pixelDifferences(const Picture& a, const Picture& b) {
  assert(a.rgba.size() == b.rgba.size());
  const std::size_t pixels = a.rgba.size() / 4;
  PixelDifferences found{.levels = std::vector<std::uint8_t>(pixels)};
  std::size_t half = pixels < kLargePicture ? pixels : pixels / 2;
  LevelCounts lower{};
  std::jthread other;
  if (half < pixels) {
    try {
      other = std::jthread([&, half] { findDifferences(a, b, half, pixels, found, lower); });
    } catch (const std::system_error&) {  // no thread available
      half = pixels;
    }
  }
  findDifferences(a, b, 0, half, found, found.counts);
  if (other.joinable()) other.join();
  for (std::size_t level = 0; level < lower.size(); ++level) found.counts[level] += lower[level];
  return found;
}

WorstTile worstTile(std::span<const std::uint8_t> differences, int width, int height) {
  assert(differences.size() == indexOf(0, height, width));
  const int tile_width = std::min(kTile, width);
  const int tile_height = std::min(kTile, height);
  WorstTile worst;
  worst.width = tile_width;
  worst.height = tile_height;
  std::int32_t largest = -1;
  const auto weigh = [&](const TileSums& tile, int x, int y) {
    worst.over = std::max<std::int64_t>(worst.over, tile.over);
    if (tile.difference <= largest) return;
    largest = tile.difference;
    worst.x = x;
    worst.y = y;
  };
  // Each tile of the grid has four quarters.
  std::vector<TileSums> above(static_cast<std::size_t>(width / kStride));
  std::vector<TileSums> below = above;
  for (int top = 0; top + kStride <= height; top += kStride) {
    std::swap(above, below);
    sumQuarters(differences, width, top, below);
    if (top == 0) continue;
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
      TileSums tile = above[i];
      tile += above[i + 1];
      tile += below[i];
      tile += below[i + 1];
      weigh(tile, static_cast<int>(i) * kStride, top - kStride);
    }
  }
  // Tiles flush with the far edges, and pictures smaller than a tile.
  const int last_x = width - tile_width;
  const int last_y = height - tile_height;
  const auto weighAt = [&](int x, int y) {
    weigh(sumsOf(differences, width, x, y, tile_width, tile_height), x, y);
  };
  for (int x = 0; x < last_x; x += kStride) weighAt(x, last_y);
  for (int y = 0; y < last_y; y += kStride) weighAt(last_x, y);
  weighAt(last_x, last_y);
  worst.mean = largest / static_cast<double>(tile_width * tile_height);
  return worst;
}

}  // namespace rocinante
