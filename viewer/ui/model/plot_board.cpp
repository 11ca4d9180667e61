#include "viewer/ui/model/plot_board.h"

#include <algorithm>
#include <utility>

namespace rocinante {

const PlotBoard::Curve* PlotBoard::find(const SeriesKey& key) const {
  const auto found = std::ranges::find(curves_, key, &Curve::key);
  return found == curves_.end() ? nullptr : &*found;
}

bool PlotBoard::add(SeriesKey key) {
  hidden = false;
  if (find(key) != nullptr) return true;
  if (curves_.size() >= kMaxCurves) return false;
  std::size_t color = 0;
  while (std::ranges::find(curves_, color, &Curve::color) != curves_.end()) ++color;
  curves_.push_back({std::move(key), color});
  return true;
}

void PlotBoard::remove(const SeriesKey& key) {
  std::erase_if(curves_, [&](const Curve& curve) { return curve.key == key; });
}

bool PlotBoard::toggle(const SeriesKey& key) {
  if (find(key) == nullptr) return add(key);
  remove(key);
  return true;
}

}  // namespace rocinante
