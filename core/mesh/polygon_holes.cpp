#include <algorithm>
#include <functional>
#include <numeric>

#include "core/mesh/polygon.h"

namespace rocinante {
namespace {

/// Positive where c is left of the way from a to b.
double sideOf(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One loop of corners, to which holes are joined one after another.
class HoleBridges {
 public:
  HoleBridges(const std::vector<Vec2>& flat, std::span<const std::size_t> ends) : flat_(flat) {
    std::size_t from = 0;
    for (const std::size_t end : ends) {
      rings_.emplace_back();
      for (std::size_t i = from; i < end; ++i) {
        rings_.back().push_back(static_cast<std::uint32_t>(i));
      }
      from = end;
    }
    loop_ = std::move(rings_.front());
    rings_.erase(rings_.begin());
    for (Ring& hole : rings_) turnClockwise(hole);
    // From the right: a hole's rightmost corner sees the outline or a hole joined before it.
    std::ranges::stable_sort(rings_, std::ranges::greater(),
                             [&](const Ring& hole) { return flat_[hole.front()].x; });
  }

  std::vector<std::uint32_t> loop() {
    for (std::size_t i = 0; i < rings_.size(); ++i) join(i);
    return std::move(loop_);
  }

 private:
  using Ring = std::vector<std::uint32_t>;

  /// Also puts the rightmost corner first.
  void turnClockwise(Ring& hole) const {
    double area = 0;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const Vec2 &a = flat_[hole[i]], &b = flat_[hole[(i + 1) % hole.size()]];
      area += a.x * b.y - a.y * b.x;
    }
    if (area > 0) std::ranges::reverse(hole);
    const auto right =
        std::ranges::max_element(hole, {}, [&](std::uint32_t corner) { return flat_[corner].x; });
    std::rotate(hole.begin(), right, hole.end());
  }

  bool isInside(std::size_t at, const Vec2& point) const {
    const Vec2& before = flat_[loop_[at == 0 ? loop_.size() - 1 : at - 1]];
    const Vec2& corner = flat_[loop_[at]];
    const Vec2& after = flat_[loop_[(at + 1) % loop_.size()]];
    const bool left_of_next = sideOf(corner, after, point) >= 0;
    const bool left_of_last = sideOf(before, corner, point) >= 0;
    return sideOf(before, corner, after) >= 0 ? left_of_next && left_of_last
                                              : left_of_next || left_of_last;
  }

  bool crosses(const Ring& ring, const Vec2& from, const Vec2& to) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = flat_[ring[i]], &b = flat_[ring[(i + 1) % ring.size()]];
      if (a == from || b == from || a == to || b == to) continue;
      if (sideOf(from, to, a) * sideOf(from, to, b) <= 0 &&
          sideOf(a, b, from) * sideOf(a, b, to) <= 0) {
        return true;
      }
    }
    return false;
  }

  bool isFree(std::size_t hole, const Vec2& from, const Vec2& to) const {
    if (crosses(loop_, from, to)) return false;
    for (std::size_t other = hole; other < rings_.size(); ++other) {
      if (crosses(rings_[other], from, to)) return false;
    }
    return true;
  }

  void join(std::size_t number) {
    const Ring& hole = rings_[number];
    const Vec2& from = flat_[hole.front()];
    std::vector<std::size_t> nearest(loop_.size());
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::ranges::stable_sort(nearest, {}, [&](std::size_t at) {
      const Vec2 way = flat_[loop_[at]] - from;
      return way.x * way.x + way.y * way.y;
    });
    const auto seen = std::ranges::find_if(nearest, [&](std::size_t at) {
      return isInside(at, from) && isFree(number, from, flat_[loop_[at]]);
    });
    // None: the rings cross. Something is drawn all the same.
    const std::size_t at = seen == nearest.end() ? nearest.front() : *seen;
    Ring way = hole;
    way.push_back(hole.front());
    way.push_back(loop_[at]);
    loop_.insert(loop_.begin() + static_cast<std::ptrdiff_t>(at) + 1, way.begin(), way.end());
  }

  const std::vector<Vec2>& flat_;
  std::vector<Ring> rings_;  ///< the holes, clockwise
  Ring loop_;
};

}  // namespace

std::vector<std::uint32_t> loopAroundHoles(std::span<const glm::vec3> corners,
                                           std::span<const std::size_t> ends) {
  std::vector<Vec2> flat;
  flattenPolygon(corners, ends.front(), flat);
  return HoleBridges(flat, ends).loop();
}

}  // namespace rocinante
