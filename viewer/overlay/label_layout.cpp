#include "viewer/overlay/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rocinante {
namespace {

constexpr int kPaddingX = 4;
constexpr int kPaddingY = 2;
/// Pixels between plates.
constexpr int kPlateGap = 2;

/// Plates by the grid squares of the picture that they touch, for fast lookup.
class TakenPlaces {
 public:
  TakenPlaces(int width, int height)
      : columns_(width / kSquare + 1), rows_(height / kSquare + 1), squares_(count()) {}

  bool isFree(const ScreenBox& box) const {
    return forEachSquare(box, [&](const std::vector<ScreenBox>& square) {
      return std::none_of(square.begin(), square.end(),
                          [&](const ScreenBox& other) { return other.overlaps(box); });
    });
  }

  void take(const ScreenBox& box) {
    const auto& self = *this;
    self.forEachSquare(box, [&](const std::vector<ScreenBox>& square) {
      const auto place = static_cast<std::size_t>(&square - squares_.data());
      squares_[place].push_back(box);
      return true;
    });
  }

 private:
  static constexpr int kSquare = 64;

  std::size_t count() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }

  /// False as soon as `each` returns false.
  template <class Each>
  bool forEachSquare(const ScreenBox& box, const Each& each) const {
    const int last_column = std::clamp((box.right - 1) / kSquare, 0, columns_ - 1);
    const int last_row = std::clamp((box.bottom - 1) / kSquare, 0, rows_ - 1);
    for (int row = std::clamp(box.top / kSquare, 0, rows_ - 1); row <= last_row; ++row) {
      for (int column = std::clamp(box.left / kSquare, 0, columns_ - 1); column <= last_column;
           ++column) {
        if (!each(squares_[static_cast<std::size_t>(row * columns_ + column)])) return false;
      }
    }
    return true;
  }

  int columns_, rows_;
  std::vector<std::vector<ScreenBox>> squares_;
};

/// First the default place of labels: up and to the right of the anchor.
struct PlateSide {
  int x, y;  ///< -1: left of and above the anchor, 0: centred, 1: right of and below
};
constexpr std::array kSides{PlateSide{1, -1}, PlateSide{1, 1}, PlateSide{-1, -1}, PlateSide{-1, 1},
                            PlateSide{0, -1}, PlateSide{0, 1}, PlateSide{1, 0},   PlateSide{-1, 0}};
constexpr std::array kDistances{10, 26, 48, 76};

ScreenBox boxBeside(const LabelAnchor& anchor, const PlateSide& side, int distance) {
  const int x = static_cast<int>(std::floor(anchor.x)) + side.x * distance;
  const int y = static_cast<int>(std::floor(anchor.y)) + side.y * distance;
  const int width = anchor.text.width + 2 * kPaddingX;
  const int height = anchor.text.height + 2 * kPaddingY;
  const int left = side.x > 0 ? x : side.x < 0 ? x - width : x - width / 2;
  const int top = side.y > 0 ? y : side.y < 0 ? y - height : y - height / 2;
  return {left, top, left + width, top + height};
}

}  // namespace

std::vector<std::optional<ScreenBox>> layOutLabels(const std::vector<LabelAnchor>& anchors,
                                                   const std::vector<ScreenBox>& taken, int width,
                                                   int height) {
  TakenPlaces places(width, height);
  for (const ScreenBox& box : taken) places.take(box);
  std::vector<std::optional<ScreenBox>> plates(anchors.size());
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const auto find = [&]() -> std::optional<ScreenBox> {
      for (const int distance : kDistances) {
        for (const PlateSide& side : kSides) {
          const ScreenBox box = boxBeside(anchors[i], side, distance);
          const bool inside =
              box.left >= 0 && box.top >= 0 && box.right <= width && box.bottom <= height;
          const ScreenBox wide{box.left - kPlateGap, box.top - kPlateGap, box.right + kPlateGap,
                               box.bottom + kPlateGap};
          if (inside && places.isFree(wide)) return box;
        }
      }
      return std::nullopt;
    };
    plates[i] = find();
    if (plates[i]) places.take(*plates[i]);
  }
  return plates;
}

}  // namespace rocinante
