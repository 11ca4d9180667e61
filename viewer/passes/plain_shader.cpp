#include "viewer/passes/plain_shader.h"

namespace rocinante::shader {

const std::string_view kPlainVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_place;
layout(location = 3) in vec3 point_color;
uniform mat4 clip_from_model;
uniform mat3 normal_from_model;
uniform vec4 map_along;  // u, v: MapPlacing
uniform vec2 map_offset;
uniform vec4 diffuse;
uniform vec3 emission;
uniform bool has_tint;
uniform vec3 key_direction;  // towards the light
out vec3 shade;
out vec2 map_place;
void main() {
  gl_Position = clip_from_model * vec4(position, 1.0);
  map_place = texture_place.x * map_along.xy + texture_place.y * map_along.zw + map_offset;
  vec3 n = normal_from_model * normal;
  float length2 = dot(n, n);
  float key = 1.0;
  if (length2 > 0.0) key = min(abs(dot(n, key_direction)) * (1.0 / sqrt(length2)), 1.0);
  vec3 base = diffuse.rgb;
  if (has_tint) base *= point_color;
  shade = base * (0.45 + 0.55 * key) + emission;
}
)";

const std::string_view kBatchedPlainVertex = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 2) in vec3 normal;
uniform vec4 diffuse;
uniform vec3 emission;
uniform vec3 key_direction;  // towards the light
out vec3 shade;
void main() {
  gl_Position = clip;
  float length2 = dot(normal, normal);
  float key = 1.0;
  if (length2 > 0.0) key = min(abs(dot(normal, key_direction)) * (1.0 / sqrt(length2)), 1.0);
  shade = diffuse.rgb * (0.45 + 0.55 * key) + emission;
}
)";

const std::string_view kPlainFragment = R"(#version 330 core
in vec3 shade;
uniform vec4 diffuse;
out vec4 color;
void main() { color = vec4(shade, diffuse.a); }
)";

const std::string_view kPlainMappedFragment = R"(#version 330 core
in vec3 shade;
in vec2 map_place;
uniform vec4 diffuse;
uniform sampler2D map;
#ifdef CUTOUT
uniform float cutoff;
#endif
out vec4 color;
void main() {
  vec4 texel = texture(map, map_place);
#ifdef CUTOUT
  if (texel.a < cutoff) discard;
  texel.a = 1.0;
#endif
  color = vec4(shade, diffuse.a) * texel;
}
)";

}  // namespace rocinante::shader
