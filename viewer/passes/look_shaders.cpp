#include "viewer/passes/look_shaders.h"

namespace rocinante::shader {

const std::string_view kShadowLookup = R"(
uniform mat4 map_from_relative;
uniform float texel_m;
uniform sampler2D shadow_map;
// How much of the light comes to a place: the average over two texels each way, weighted by what
// they share of it, so that edges are even and stand still.
float litAt(vec3 relative) {
  vec3 place = (map_from_relative * vec4(relative, 1.0)).xyz;
  float side = float(textureSize(shadow_map, 0).x);
  vec2 at = place.xy * side;
  if (min(at.x, at.y) < 2.0 || max(at.x, at.y) > side - 2.0) return 1.0;
  vec2 part = fract(at);
  ivec2 corner = ivec2(at) - 1;
  vec3 across = vec3(1.0 - part.x, 1.0, part.x);
  vec3 down = vec3(1.0 - part.y, 1.0, part.y);
  float sum = 0.0;
  for (int y = 0; y < 3; ++y) {
    vec3 seen;
    for (int x = 0; x < 3; ++x) {
      float nearest = texelFetch(shadow_map, corner + ivec2(x, y), 0).r;
      seen[x] = nearest > place.z ? 0.0 : 1.0;
    }
    sum += dot(seen, across) * down[y];
  }
  return sum * 0.25;
}
)";

const std::string_view kFlatVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clip_from_model;
void main() { gl_Position = clip_from_model * vec4(position, 1.0); }
)";

const std::string_view kFlatFragment = R"(#version 330 core
uniform vec4 flat_color;
out vec4 color;
void main() { color = flat_color; }
)";

const std::string_view kEdgeVertex = R"(#version 330 core
uniform mat4 clip_from_model;
uniform vec4 eye;  // in the model: its place (w = 1), or the direction towards it (w = 0)
uniform int first_edge;
uniform bool every_edge;
uniform bool alone;
uniform vec2 viewport;
uniform float near;  // the least w that can be seen
uniform vec2 lift;   // towards the eye: a part of the distance, and a depth
uniform float low;   // clip depth runs from -low to 1
uniform float unit_px;  // pixels of a unit of the model where w is 1
uniform sampler2D edges;
const float kWidth = 1.25;     // pixels
const float kFullWidth = 5.0;  // of a face, in pixels: lines along narrower ones fade
out float weight;
void main() {
  int edge = first_edge + gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  ivec2 place = ivec2(edge % 1024 * 4, edge / 1024);
  vec4 one = texelFetch(edges, place, 0);
  vec4 two = texelFetch(edges, place + ivec2(1, 0), 0);
  vec4 three = texelFetch(edges, place + ivec2(2, 0), 0);
  vec3 to_eye = eye.xyz - one.xyz * eye.w;
  float first = dot(vec3(one.w, two.w, three.w), to_eye);
  float second = dot(three.xyz, to_eye);
  vec4 a = clip_from_model * vec4(one.xyz, 1.0);
  vec4 b = clip_from_model * vec4(two.xyz, 1.0);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // nowhere in the picture
  weight = 1.0;
  // Both normals are zero where the edge is always drawn.
  if (!every_edge && first * second > 0.0) return;
  if (a.w < near && b.w < near) return;
  if (a.w < near) a += (b - a) * ((near - a.w) / (b.w - a.w));
  else if (b.w < near) b += (a - b) * ((near - b.w) / (a.w - b.w));
  vec2 way = (b.xy / b.w - a.xy / a.w) * viewport;
  float length_px = sqrt(dot(way, way));
  way = length_px > 1e-6 ? way * (1.0 / length_px) : vec2(1.0, 0.0);
  bool at_a = corner == 0 || corner == 1 || corner == 3;
  float side = corner == 0 || corner == 2 || corner == 4 ? 1.0 : -1.0;
  vec4 end = at_a ? a : b;
  if (!every_edge) {
    // Lines stand the denser the narrower faces are: by this alone as much of them shows in all
    // however far they are, by its square ever less, so that surfaces keep their shade.
    float face_px = texelFetch(edges, place + ivec2(3, 0), 0).x * unit_px / end.w;
    weight = clamp(face_px / kFullWidth, 0.0, 1.0);
    if (!alone) weight *= weight;
  }
  // Half a width across, and a little beyond its ends, so that lines which meet close.
  vec2 away = vec2(-way.y, way.x) * side + way * (at_a ? -0.6 : 0.6);
  end.xy += away * kWidth / viewport * end.w;
  end.z = (end.z + low * end.w) * (1.0 + lift.x) - low * end.w + lift.y * end.w;
  gl_Position = end;
}
)";

const std::string_view kEdgeFragment = R"(#version 330 core
in float weight;
uniform vec4 flat_color;
out vec4 color;
void main() { color = vec4(flat_color.rgb, flat_color.a * weight); }
)";

const std::string_view kGhostFragment = R"(#version 330 core
in vec3 from_eye;
in vec3 world_normal;
uniform bool orthographic;
uniform vec3 view_direction;
uniform vec4 tone;
out vec4 color;
void main() {
  vec3 to_eye = orthographic ? -view_direction : -from_eye * (1.0 / sqrt(dot(from_eye, from_eye)));
  float normal_length = dot(world_normal, world_normal);
  vec3 n = normal_length > 0.0 ? world_normal * (1.0 / sqrt(normal_length)) : to_eye;
  float facing = min(abs(dot(n, to_eye)), 1.0);
  float rim = (1.0 - facing) * (1.0 - facing);
  // Clear in the middle, dense and bright at the rims; a little of the sky tells up from down.
  float shade = 0.82 + 0.10 * n.z * (dot(n, to_eye) < 0.0 ? -1.0 : 1.0);
  vec3 shown = mix(tone.rgb * shade, mix(tone.rgb, vec3(1.0), 0.35), rim);
  color = vec4(shown, tone.a + (1.0 - tone.a) * (0.08 + 0.72 * rim));
}
)";

const std::string_view kOutlineVertex = R"(#version 330 core
uniform vec4 box;   // pixels from the bottom left: left, bottom, right, top
uniform vec2 size;  // of the picture
out vec2 place;     // in the box
void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? box.x : box.z, (gl_VertexID & 2) == 0 ? box.y : box.w);
  place = corner - box.xy;
  gl_Position = vec4(corner / size * 2.0 - 1.0, 0.0, 1.0);
}
)";

const std::string_view kOutlineFragment = R"(#version 330 core
in vec2 place;
uniform sampler2D cover;
uniform vec4 line_color;
out vec4 color;
void main() {
  float part = texelFetch(cover, ivec2(floor(place)), 0).r;
  if (part <= 0.0) discard;
  color = vec4(line_color.rgb, line_color.a * part);
}
)";

namespace {

constexpr std::string_view kVersion = "#version 330 core\n";

}  // namespace

std::string withShadows(std::string_view source, bool looks_up) {
  std::string text(kVersion);
  text += "#define SHADOWS\n";
  if (looks_up) text += kShadowLookup;
  text += source.substr(kVersion.size());
  return text;
}

std::string withLights(std::string_view source, std::size_t count) {
  std::string text(kVersion);
  if (count > 0) text += "#define LIGHTS " + std::to_string(count) + "\n";
  text += source.substr(kVersion.size());
  return text;
}

}  // namespace rocinante::shader
