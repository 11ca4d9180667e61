#include "viewer/passes/shader_source.h"

namespace rocinante::shader {

const std::string_view kSceneVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_place;
layout(location = 3) in vec3 point_color;
uniform mat4 clip_from_model;
uniform mat4 relative_from_model;  // world axes, origin at the eye
uniform mat3 normal_from_model;
uniform vec4 map_along;  // u, v: MapPlacing
uniform vec2 map_offset;
out vec3 from_eye;
out vec3 world_normal;
out vec2 map_place;
out vec3 tint;
void main() {
  tint = point_color;
  gl_Position = clip_from_model * vec4(position, 1.0);
  from_eye = (relative_from_model * vec4(position, 1.0)).xyz;
  world_normal = normal_from_model * normal;
  map_place = texture_place.x * map_along.xy + texture_place.y * map_along.zw + map_offset;
}
)";

const std::string_view kBatchedVertex = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec3 relative;
layout(location = 2) in vec3 normal;
out vec3 from_eye;
out vec3 world_normal;
out vec2 map_place;
out vec3 tint;
void main() {
  gl_Position = clip;
  from_eye = relative;
  world_normal = normal;
  map_place = vec2(0.0);
  tint = vec3(1.0);
}
)";

const std::string_view kSceneFragment = R"(#version 330 core
in vec3 from_eye;
in vec3 world_normal;
in vec2 map_place;
in vec3 tint;
uniform vec4 diffuse;
uniform vec3 specular;
uniform vec3 emission;
uniform float shininess;
uniform bool has_map;
uniform bool has_tint;
uniform bool orthographic;
uniform vec3 view_direction;
uniform vec3 key_direction;   // towards the light
uniform vec3 fill_direction;
uniform sampler2D map;
#ifdef CUTOUT
uniform float cutoff;  // of the texture's alpha
#endif
#ifdef LIGHTS
uniform vec3 light_direction[LIGHTS];  // towards them; of the first the same as key_direction
uniform vec3 light_color[LIGHTS];
#endif
out vec4 color;

// Polynomials close to the sRGB curve (within 1/255), from arithmetic and roots alone.
vec3 lightOf(vec3 shown) {
  return shown * (shown * (shown * 0.305306011 + 0.682171111) + 0.012522878);
}
vec3 shownOf(vec3 light) {
  vec3 root2 = sqrt(max(light, vec3(0.0)));
  vec3 root4 = sqrt(root2);
  vec3 root8 = sqrt(root4);
  return 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * light;
}

void main() {
  vec3 to_eye = orthographic ? -view_direction : -from_eye * (1.0 / sqrt(dot(from_eye, from_eye)));
  // Models of the wild turn their triangles either way, so both sides are lit. Which side is seen
  // comes from the surface itself, not from the normal, which may lean away at an outline.
  vec3 face = cross(dFdx(from_eye), dFdy(from_eye));
  if (dot(face, to_eye) < 0.0) face = -face;
  float normal_length = dot(world_normal, world_normal);
  vec3 n = normal_length > 0.0 ? world_normal * (1.0 / sqrt(normal_length)) : vec3(0.0, 0.0, 1.0);
  if (dot(n, face) < 0.0) n = -n;

  vec4 base = vec4(lightOf(diffuse.rgb), diffuse.a);
  if (has_tint) base.rgb *= lightOf(tint);
  if (has_map) {
    vec4 texel = texture(map, map_place);
#ifdef CUTOUT
    if (texel.a < cutoff) discard;
    texel.a = 1.0;
#endif
    base *= vec4(lightOf(texel.rgb), texel.a);
  }
  // Sky above, ground below, a key light, and a soft one that moves with the camera, from its upper
  // left: walls that meet differ in shade wherever one stands.
  vec3 ambient = mix(vec3(0.12, 0.11, 0.10), vec3(0.27, 0.29, 0.32), n.z * 0.5 + 0.5);
  float key = max(dot(n, key_direction), 0.0);
#ifdef SHADOWS
  // From a texel and a half above the surface: it must not lie in its own shadow.
  if (key > 0.0) key *= litAt(from_eye + n * (texel_m * 1.5));
#endif
#ifdef CONTACT
  // Light from all sides is kept away by what is near, that of lamps less. The terms are exact, so
  // that an open place (1) has the bits that it has without the look.
  float open = openAt(dot(from_eye, view_direction));
  float lamps = open * 0.625 + 0.375;
  ambient *= open;
  key *= lamps;
#endif
#ifdef LIGHTS
  vec3 light = base.rgb * ambient;
  for (int i = 0; i < LIGHTS; ++i) {
    float part = i == 0 ? key : max(dot(n, light_direction[i]), 0.0);
#ifdef CONTACT
    if (i > 0) part *= lamps;
#endif
    light += base.rgb * light_color[i] * part;
    vec3 half_way = light_direction[i] + to_eye;
    float facing = dot(n, half_way) * (1.0 / sqrt(max(dot(half_way, half_way), 1e-6)));
    if (shininess > 0.0 && facing > 0.0 && part > 0.0) {
      light += lightOf(specular) * light_color[i] * pow(facing, shininess);
    }
  }
#else
  float fill = max(dot(n, fill_direction), 0.0);
#ifdef CONTACT
  fill *= open;
#endif
  vec3 light = base.rgb * (ambient + vec3(0.54, 0.52, 0.49) * key + vec3(0.20, 0.21, 0.22) * fill);
  if (shininess > 0.0) {
    vec3 half_way = key_direction + to_eye;
    float facing = dot(n, half_way) * (1.0 / sqrt(max(dot(half_way, half_way), 1e-6)));
    if (facing > 0.0 && key > 0.0) light += lightOf(specular) * pow(facing, shininess) * 0.5;
  }
#endif
  light += lightOf(emission);
  color = vec4(shownOf(min(light, vec3(1.0))), base.a);
}
)";

const std::string_view kMappedVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texture_place;
uniform mat4 clip_from_model;
uniform vec4 map_along;
uniform vec2 map_offset;
out vec2 map_place;
void main() {
  gl_Position = clip_from_model * vec4(position, 1.0);
  map_place = texture_place.x * map_along.xy + texture_place.y * map_along.zw + map_offset;
}
)";

const std::string_view kHolesFragment = R"(#version 330 core
in vec2 map_place;
uniform sampler2D map;
uniform float cutoff;
out vec4 color;
void main() {
  if (texture(map, map_place).a < cutoff) discard;
  color = vec4(0.0);
}
)";

std::string withCutout(std::string_view source) {
  constexpr std::string_view kFirst = "#version 330 core\n";
  return std::string(kFirst).append("#define CUTOUT\n").append(source.substr(kFirst.size()));
}

const std::string_view kBackgroundVertex = R"(#version 330 core
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = corner.y * 0.5 + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const std::string_view kBackgroundFragment = R"(#version 330 core
in float height;
uniform vec3 top;
uniform vec3 bottom;
out vec4 color;
void main() { color = vec4(mix(bottom, top, height), 1.0); }
)";

const std::string_view kGridVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;  // from -1 to 1
uniform mat4 clip_from_relative;
uniform vec3 center_from_eye;  // the world's origin, seen from the eye
uniform float half_size;
out vec2 ground;  // metres from the origin
#if defined(SHADOWS) || defined(CONTACT)
out vec3 from_eye;
#endif
void main() {
  ground = corner * half_size;
#if defined(SHADOWS) || defined(CONTACT)
  from_eye = center_from_eye + vec3(ground, 0.0);
#endif
  gl_Position = clip_from_relative * vec4(center_from_eye + vec3(ground, 0.0), 1.0);
}
)";

const std::string_view kGridFragment = R"(#version 330 core
in vec2 ground;
#if defined(SHADOWS) || defined(CONTACT)
in vec3 from_eye;
uniform vec3 view_direction;
#endif
uniform float grid_step;
uniform float half_size;
uniform float scale;
out vec4 color;

// How much of a pixel the lines of one step cover: `wide` pixels each, fading out where they stand
// closer than a few pixels and would only shimmer.
float covered(float apart, float wide) {
  vec2 place = ground / apart;
  vec2 pixel = vec2(sqrt(dFdx(place.x) * dFdx(place.x) + dFdy(place.x) * dFdy(place.x)),
                    sqrt(dFdx(place.y) * dFdx(place.y) + dFdy(place.y) * dFdy(place.y)));
  pixel = max(pixel, vec2(1e-6)) * scale;
  vec2 away = abs(fract(place - 0.5) - 0.5) / pixel;
  vec2 line = clamp(vec2(wide * 0.5 + 0.5) - away, 0.0, 1.0);
  line *= clamp(vec2(1.4) - pixel * 4.0, 0.0, 1.0);
  return max(line.x, line.y);
}
float axis(float place) {
  float pixel = max(sqrt(dFdx(place) * dFdx(place) + dFdy(place) * dFdy(place)), 1e-6) * scale;
  return clamp(1.5 - abs(place) / pixel, 0.0, 1.0);
}

void main() {
  float away = sqrt(dot(ground, ground)) / half_size;
  float fade = clamp((1.0 - away) * 1.8, 0.0, 1.0);
  float fine = covered(grid_step, 1.0) * 0.30;
  float coarse = covered(grid_step * 5.0, 1.3) * 0.50;
  float strength = max(fine, coarse);
  vec3 shade = vec3(0.22, 0.25, 0.29);
  float x_axis = axis(ground.y);
  float y_axis = axis(ground.x);
  if (x_axis > 0.0) { shade = vec3(0.75, 0.22, 0.20); strength = max(strength, x_axis * 0.75); }
  else if (y_axis > 0.0) { shade = vec3(0.22, 0.56, 0.22); strength = max(strength, y_axis * 0.75); }
  color = vec4(shade, strength * fade);
#if defined(SHADOWS) || defined(CONTACT)
  // The ground is no surface: it shows shadows and nothing else. Lines over them.
  float lit = 1.0;
#ifdef SHADOWS
  lit = litAt(from_eye + vec3(0.0, 0.0, texel_m));
#endif
#ifdef CONTACT
  lit *= openAt(dot(from_eye, view_direction));
#endif
  float dark = (1.0 - lit) * 0.34 * fade;
  float both = color.a + dark * (1.0 - color.a);
  color = vec4(mix(vec3(0.04, 0.05, 0.07), shade, color.a / max(both, 1e-6)), both);
#endif
}
)";

const std::string_view kOverlayVertex = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 vertex_color;
layout(location = 3) in uint vertex_kind;
out vec2 place;
out vec4 shade;
flat out uint kind;
void main() {
  gl_Position = clip;
  place = texture_place;
  shade = vertex_color;
  kind = vertex_kind;
}
)";

const std::string_view kOverlayFragment = R"(#version 330 core
in vec2 place;
in vec4 shade;
flat in uint kind;
uniform sampler2D atlas;
out vec4 color;
void main() {
  float cover = 1.0;
  if (kind == 1u) {
    float away = sqrt(dot(place, place));
    float pixel = max(sqrt(dFdx(away) * dFdx(away) + dFdy(away) * dFdy(away)), 1e-6);
    cover = clamp((1.0 - away) / pixel + 0.5, 0.0, 1.0);
  } else if (kind == 2u) {
    cover = texelFetch(atlas, ivec2(floor(place)), 0).r;
  }
  if (cover <= 0.0) discard;
  color = vec4(shade.rgb, shade.a * cover);
}
)";

}  // namespace rocinante::shader
