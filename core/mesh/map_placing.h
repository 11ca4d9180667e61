#pragma once

#include "core/mesh/mesh.h"

namespace rocinante {

/// How a material's image lies on texture coordinates: scaled, turned, then moved.
struct MapPlacing {
  glm::vec2 along_u{1.0F, 0.0F}, along_v{0.0F, 1.0F}, offset{0.0F, 0.0F};

  explicit MapPlacing(const Material& material);
  /// Sums in this order, as shaders do: without a turn it is scale and offset to the bit.
  glm::vec2 of(const glm::vec2& texture) const {
    return texture.x * along_u + texture.y * along_v + offset;
  }
  bool operator==(const MapPlacing&) const = default;
};

}  // namespace rocinante
