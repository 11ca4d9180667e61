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
  curves_.push_back({std::move(key), freeColor()});
  return true;
}

std::size_t PlotBoard::freeColor() const {
  std::size_t color = 0;
  while (std::ranges::find(curves_, color, &Curve::color) != curves_.end() ||
         std::ranges::find(paths_, color, &Path::color) != paths_.end()) {
    ++color;
  }
  return color;
}

bool PlotBoard::addPath(SeriesKey y, SeriesKey x) {
  hidden = false;
  const bool is_there =
      std::ranges::any_of(paths_, [&](const Path& path) { return path.y == y && path.x == x; });
  if (is_there) return true;
  if (paths_.size() >= kMaxPaths) return false;
  height = std::max(height, kPathHeight);
  paths_.push_back({std::move(y), std::move(x), freeColor()});
  return true;
}

bool PlotBoard::removePath(const SeriesKey& y, const SeriesKey& x) {
  return std::erase_if(paths_, [&](const Path& path) { return path.y == y && path.x == x; }) > 0;
}

void PlotBoard::clear() {
  curves_.clear();
  paths_.clear();
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
