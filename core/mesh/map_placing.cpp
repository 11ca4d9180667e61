#include "core/mesh/map_placing.h"

#include "core/math/trigonometry.h"

namespace rocinante {

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
