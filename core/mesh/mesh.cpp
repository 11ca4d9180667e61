#include "core/mesh/mesh.h"

#include <algorithm>

namespace rocinante {

void Bounds::add(const Vec3& point) {
  min = {std::min(min.x, point.x), std::min(min.y, point.y), std::min(min.z, point.z)};
  max = {std::max(max.x, point.x), std::max(max.y, point.y), std::max(max.z, point.z)};
}

void Bounds::add(const Bounds& other) {
  if (other.empty()) return;
  add(other.min);
  add(other.max);
}

}  // namespace rocinante
