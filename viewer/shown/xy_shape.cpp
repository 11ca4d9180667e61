#include "viewer/shown/xy_shape.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

constexpr float kSame = 0.25F;  // pixels
constexpr float kSeen = 1;

/// What a value was in a column: with what it was before, if it is known.
std::optional<std::pair<float, float>> extentOf(const ValueColumn& column,
                                                const std::optional<float>& before,
                                                const XyAxis& axis) {
  std::optional<std::pair<float, float>> extent;
  const auto include = [&](float place) {
    if (!extent) extent.emplace(place, place);
    extent->first = std::min(extent->first, place);
    extent->second = std::max(extent->second, place);
  };
  if (before) include(*before);
  if (column.bin.hasSample()) {
    include(axis.place(static_cast<double>(column.bin.low)));
    include(axis.place(static_cast<double>(column.bin.high)));
  } else if (column.held) {
    include(axis.place(static_cast<double>(*column.held)));
  }
  return extent;
}

/// More than one sample in a column, as far as that can be seen.
bool movesWithin(const ValueColumn& column) {
  return column.bin.hasSample() && column.bin.low < column.bin.high;
}

}  // namespace

float XyAxis::place(double stated) const {
  const double part = scale.part(value.shown(stated));
  return static_cast<float>(std::clamp(part, -1.0, 2.0)) * length;
}

XyShape xyShape(const XyColumns& columns, const XyAxis& x, const XyAxis& y) {
  XyShape shape;
  std::vector<PlotShape::Point> line;
  const auto lift = [&] {
    if (!line.empty()) shape.lines.push_back(std::move(line));
    line.clear();
  };
  std::optional<float> x_before, y_before;
  for (std::size_t i = 0; i < std::min(columns.x.size(), columns.y.size()); ++i) {
    const ValueColumn& of_x = columns.x[i];
    const ValueColumn& of_y = columns.y[i];
    if (movesWithin(of_x) || movesWithin(of_y)) {
      const auto wide = extentOf(of_x, x_before, x), high = extentOf(of_y, y_before, y);
      if (wide && high &&
          (wide->second - wide->first > kSeen || high->second - high->first > kSeen)) {
        shape.boxes.push_back({wide->first, wide->second, high->first, high->second});
      }
    }
    x_before.reset();
    y_before.reset();
    if (of_x.held) x_before = x.place(static_cast<double>(*of_x.held));
    if (of_y.held) y_before = y.place(static_cast<double>(*of_y.held));
    if (!x_before || !y_before) {
      lift();
      continue;
    }
    const PlotShape::Point point{*x_before, *y_before};
    const bool is_same = !line.empty() && std::abs(line.back().x - point.x) < kSame &&
                         std::abs(line.back().y - point.y) < kSame;
    if (!is_same) line.push_back(point);
  }
  lift();
  return shape;
}

void makeEqual(ValueRange& x, ValueRange& y, float width, float height) {
  const double wide = x.second - x.first, high = y.second - y.first;
  if (!(wide > 0 || high > 0) || !(width > 0) || !(height > 0)) return;
  const double unit =
      std::max(wide / static_cast<double>(width), high / static_cast<double>(height));
  const auto widen = [unit](ValueRange& range, float pixels) {
    const double middle = range.first / 2 + range.second / 2;
    const double half = unit * static_cast<double>(pixels) / 2;
    range = {middle - half, middle + half};
  };
  widen(x, width);
  widen(y, height);
}

std::optional<std::pair<double, double>> pairAt(const XyColumns& columns, double part) {
  const std::size_t count = std::min(columns.x.size(), columns.y.size());
  if (count == 0 || !(part >= 0 && part <= 1)) return std::nullopt;
  const auto at = std::min(static_cast<std::size_t>(part * static_cast<double>(count)), count - 1);
  if (!columns.x[at].held || !columns.y[at].held) return std::nullopt;
  return std::pair(static_cast<double>(*columns.x[at].held),
                   static_cast<double>(*columns.y[at].held));
}

}  // namespace rocinante
