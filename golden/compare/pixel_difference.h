#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// The difference of two pixels: the largest of |a - b| over R, G, B and A, from 0 to 255.
int pixelDifference(const std::uint8_t* a, const std::uint8_t* b);

/// The difference of each of `out.size()` RGBA pixels.
void differenceRow(const std::uint8_t* a, const std::uint8_t* b, std::span<std::uint8_t> out);
/// The same one pixel at a time: the reference for tests, and used on other machines than x86-64.
void differenceRowPlain(const std::uint8_t* a, const std::uint8_t* b, std::span<std::uint8_t> out);

/// How many pixels have each difference.
using LevelCounts = std::array<std::int64_t, 256>;

struct PixelDifferences {
  std::vector<std::uint8_t> levels;  ///< one per pixel, rows top to bottom
  LevelCounts counts{};
};

/// The difference of every pixel of two pictures of one shape. A second thread computes half of a
/// large picture; it has ended when this returns.
PixelDifferences pixelDifferences(const Picture& a, const Picture& b);

/// The worst of all 16x16 tiles of a picture of differences (docs/golden-suites.md, "Tolerances").
struct WorstTile {
  double mean = 0;   ///< largest mean difference of any tile
  int x = 0, y = 0;  ///< the upper left pixel of the first tile with it
  int width = 0, height = 0;
  std::int64_t over = 0;  ///< most pixels of any one tile that differ by more than 32
};

/// Tiles begin at every eighth pixel and flush with each far edge; a picture smaller than a tile is
/// one tile. `differences` holds width * height values.
WorstTile worstTile(std::span<const std::uint8_t> differences, int width, int height);

}  // namespace rocinante
