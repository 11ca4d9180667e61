#include "core/clearance/aimed_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/transform.h"

namespace rocinante {
namespace {

/// More than the rounding of an extent, absolutely and for each metre from the origin.
constexpr double kExtentRounding = 1e-12;

/// Of this number the extents are united, which is tighter than their box turned.
constexpr std::uint32_t kFewSolids = 32;

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

Aim aimAlong(const Vec3& unit_direction) {
  const Vec3& d = unit_direction;
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  const Vec3 other = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 across = crossOf(d, other);
  const Vec3 unit = across * (1 / lengthOf(across));
  return {d, unit, crossOf(d, unit)};
}

void AimedTree::begin(const TriangleTree& tree) {
  tree_ = &tree;
  if (nodes_.size() < tree.nodes().size()) nodes_.resize(tree.nodes().size());
  if (solids_.size() < tree.size()) solids_.resize(tree.size());
}

void AimedTree::aim(const Aim& aim, std::span<const Mat4> places, double more_m) {
  ++stamp_;
  count_ = std::min(places.size(), places_.size());
  double farthest = 0;
  for (std::size_t p = 0; p < count_; ++p) {
    const Mat4& at = places[p];
    for (std::size_t i = 0; i < 3; ++i) {
      places_[p].rows[i] = {dotOf(aim[i], Vec3(at[0])), dotOf(aim[i], Vec3(at[1])),
                            dotOf(aim[i], Vec3(at[2]))};
      places_[p].offset[i] = dotOf(aim[i], positionOf(at));
    }
    farthest = std::max(farthest, lengthOf(positionOf(at)));
  }
  more_m_ = more_m + kExtentRounding * (1 + farthest + lengthOf(tree_->centre()) + tree_->radius());
}

void AimedTree::fillNode(std::uint32_t i, Known& known) {
  const TriangleTree::Node& node = tree_->nodes()[i];
  if (node.under > kFewSolids) return fill(node.box, known);
  if (node.count > 0) {
    known.extent = ofSolid(node.first);
    for (std::uint32_t j = node.first + 1; j < node.first + node.count; ++j) {
      known.extent.add(ofSolid(j));
    }
  } else {
    known.extent = ofNode(node.first);
    known.extent.add(ofNode(node.first + 1));
  }
  known.stamp = stamp_;
}

void AimedTree::fill(const TriangleTree::Box& box, Known& known) const {
  known.stamp = stamp_;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = kFar, high = -kFar;
    for (std::size_t p = 0; p < count_; ++p) {
      const Vec3& row = places_[p].rows[i];
      const double middle = dotOf(row, box.centre) + places_[p].offset[i];
      const double half = std::fabs(row.x) * box.half.x + std::fabs(row.y) * box.half.y +
                          std::fabs(row.z) * box.half.z;
      low = std::min(low, middle - half);
      high = std::max(high, middle + half);
    }
    known.extent.low[i] = low - more_m_;
    known.extent.high[i] = high + more_m_;
  }
}

void AimedTree::fill(const Solid& solid, Known& known) const {
  known.stamp = stamp_;
  const double around = solid.radius_m + more_m_;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = kFar, high = -kFar;
    for (std::size_t p = 0; p < count_; ++p) {
      for (const Vec3& corner : solid.triangle) {
        const double at = dotOf(places_[p].rows[i], corner) + places_[p].offset[i];
        low = std::min(low, at);
        high = std::max(high, at);
      }
    }
    known.extent.low[i] = low - around;
    known.extent.high[i] = high + around;
  }
}

}  // namespace rocinante
