#include "core/mesh/mesh.h"

#include <algorithm>

#include "core/math/trigonometry.h"

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

MapPlacing::MapPlacing(const Material& material)
    : along_u(material.map_scale.x, 0.0F),
      along_v(0.0F, material.map_scale.y),
      offset(material.map_offset) {
  if (material.map_rotation == 0.0F) return;
  const SineCosine turn = sineCosine(static_cast<double>(material.map_rotation));
  const auto sine = static_cast<float>(turn.sine), cosine = static_cast<float>(turn.cosine);
  along_u = glm::vec2(cosine, sine) * material.map_scale.x;
  along_v = glm::vec2(-sine, cosine) * material.map_scale.y;
}

}  // namespace rocinante
