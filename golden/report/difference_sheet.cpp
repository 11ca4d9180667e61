#include <algorithm>
#include <array>

#include "golden/report/report_pictures.h"

namespace rocinante {
namespace {

constexpr int kTileWidth = 240;
constexpr int kTileGap = 8;
/// 40 rows of tall pictures stay below 20 megapixels.
constexpr std::size_t kMaxRows = 40;
constexpr int kMaxTileHeight = 480;
constexpr std::array<std::uint8_t, 4> kPaper = {0xF4, 0xF5, 0xF6, 0xFF};
constexpr std::array<std::uint8_t, 4> kNothing = {0xD8, 0xDA, 0xDD, 0xFF};

using Tile = std::optional<Picture>;
using TileRow = std::array<Tile, 3>;

/// As wide as a tile at most, by a whole fraction of its size.
Picture tileOf(const Picture& picture) {
  const double tallest = static_cast<double>(picture.width) * kMaxTileHeight / picture.height;
  return reducedPicture(picture, std::clamp(static_cast<int>(tallest), 1, kTileWidth));
}

TileRow tilesOf(const JudgedFrame& judged) {
  TileRow row;
  row[0] = tileOf(*judged.drawn);
  if (!judged.accepted) return row;
  row[1] = tileOf(*judged.accepted);
  const bool is_comparable = judged.accepted->width == judged.drawn->width &&
                             judged.accepted->height == judged.drawn->height;
  if (is_comparable) row[2] = tileOf(differencePicture(judged.compared(), *judged.accepted));
  return row;
}

int heightOf(const TileRow& row) {
  int height = 1;
  for (const Tile& tile : row) height = std::max(height, tile ? tile->height : 1);
  return height;
}

void fill(Picture& sheet, int left, int top, int width, int height,
          const std::array<std::uint8_t, 4>& rgba) {
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      const auto at = (static_cast<std::ptrdiff_t>(y) * sheet.width + x) * 4;
      std::copy(rgba.begin(), rgba.end(), sheet.rgba.begin() + at);
    }
  }
}

void put(Picture& sheet, int left, int top, const Picture& tile) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(tile.width) * 4;
  for (int y = 0; y < tile.height; ++y) {
    const auto from = tile.rgba.begin() + row_bytes * y;
    const auto to = (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left) * 4;
    std::copy(from, from + row_bytes, sheet.rgba.begin() + to);
  }
}

}  // namespace

std::optional<DifferenceSheet> differenceSheet(const SuiteReport& report) {
  DifferenceSheet sheet;
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict) || !judged.drawn || judged.drawn->rgba.empty()) continue;
    if (sheet.rows.size() == kMaxRows) {
      ++sheet.left_out;
    } else {
      sheet.rows.push_back(&judged);
    }
  }
  if (sheet.rows.empty()) return std::nullopt;
  return sheet;
}

Picture sheetPicture(const DifferenceSheet& sheet) {
  std::vector<TileRow> rows;
  int height = kTileGap;
  for (const JudgedFrame* const judged : sheet.rows) {
    rows.push_back(tilesOf(*judged));
    height += heightOf(rows.back()) + kTileGap;
  }
  Picture picture;
  picture.width = 3 * (kTileWidth + kTileGap) + kTileGap;
  picture.height = height;
  picture.rgba.resize(static_cast<std::size_t>(picture.width) *
                      static_cast<std::size_t>(picture.height) * 4);
  fill(picture, 0, 0, picture.width, picture.height, kPaper);
  int top = kTileGap;
  for (const TileRow& row : rows) {
    const int row_height = heightOf(row);
    int left = kTileGap;
    for (const Tile& tile : row) {
      if (tile) {
        put(picture, left + (kTileWidth - tile->width) / 2, top, *tile);
      } else {
        fill(picture, left, top, kTileWidth, row_height, kNothing);
      }
      left += kTileWidth + kTileGap;
    }
    top += row_height + kTileGap;
  }
  return picture;
}

}  // namespace rocinante
