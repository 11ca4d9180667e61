#include <algorithm>
#include <cassert>

#include "golden/compare.h"
#include "golden/pixel_difference.h"

namespace rocinante {

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
