#include "viewer/shown/plot_shape.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

/// Beyond this extent in one pixel a line would only be a row of spikes.
constexpr float kFast = 3;
/// Over more pixels a bend could add up to more than one.
constexpr float kStraight = 8;
/// A step at least this high is drawn as one: level, then upright.
constexpr float kStep = 2;

/// Draws a pen over the lane from left to right.
class Pen {
 public:
  explicit Pen(PlotShape& shape) : shape_(shape) {}

  void to(float x, float y) {
    const std::size_t count = line_.size();
    if (count >= 2) {
      const PlotShape::Point& a = line_[count - 2];
      PlotShape::Point& b = line_[count - 1];
      const float slope = (b.y - a.y) * (x - a.x) - (y - a.y) * (b.x - a.x);
      const bool goes_on = b.x > a.x || (x == b.x && (y - b.y) * (b.y - a.y) >= 0);
      const bool level = a.y == b.y && b.y == y;
      const bool straight = x - a.x < kStraight && std::abs(slope) <= 0.25F * (x - a.x);
      if (goes_on && (level || straight)) {
        b = {x, y};
        return;
      }
    }
    if (count > 0 && line_.back() == PlotShape::Point{x, y}) return;
    line_.push_back({x, y});
  }
  void lift() {
    if (line_.size() >= 2) shape_.lines.push_back(line_);
    line_.clear();
  }
  bool isDown() const { return !line_.empty(); }

 private:
  PlotShape& shape_;
  std::vector<PlotShape::Point> line_;
};

}  // namespace

PlotShape plotShape(const std::vector<ValueColumn>& columns, const PlotValue& value,
                    const PlotScale& scale, float height) {
  PlotShape shape;
  Pen pen(shape);
  const auto place = [&](float stated) {
    const double part = scale.part(value.shown(static_cast<double>(stated)));
    return static_cast<float>(std::clamp(part, -1.0, 2.0)) * height;
  };
  std::optional<float> before;  // where the value was as the column began
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ValueColumn& column = columns[i];
    const auto left = static_cast<float>(i);
    if (column.bin.hasSample()) {
      const float last = place(column.bin.last);
      float low = std::min(place(column.bin.low), place(column.bin.high));
      float high = std::max(place(column.bin.low), place(column.bin.high));
      if (high - low > kFast) {
        if (before) {
          low = std::min(low, *before);
          high = std::max(high, *before);
        }
        shape.bars.push_back({left, low, high});
        if (before && pen.isDown()) pen.to(left, *before);
        pen.lift();
        pen.to(left + 0.5F, last);
      } else if (before && std::abs(last - *before) >= kStep && i > 0 &&
                 !columns[i - 1].bin.hasSample()) {
        pen.to(left + 0.5F, *before);
        pen.to(left + 0.5F, last);
      } else {
        pen.to(left + 0.5F, last);
      }
    }
    if (!column.held) {
      pen.lift();
      before.reset();
      continue;
    }
    const float held = place(*column.held);
    const bool next_holds = i + 1 == columns.size() || !columns[i + 1].bin.hasSample();
    if (next_holds) {
      if (!pen.isDown()) pen.to(left, held);
      pen.to(left + 1, held);
    }
    before = held;
  }
  pen.lift();
  return shape;
}

}  // namespace rocinante
