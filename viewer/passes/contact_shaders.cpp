#include "viewer/passes/contact_shaders.h"

namespace rocinante::shader {
namespace {

constexpr std::string_view kFirstLine = "#version 330 core\n";

/// Of the four nearest texels those count that lie at the depth of the place itself, so that
/// nothing leaks over an outline. Texels lie at whole coordinates (kEvenedFragment).
constexpr std::string_view kLookup = R"(
uniform sampler2D contact_map;
uniform vec2 contact_origin;
uniform vec2 contact_scale;
float openAt(float away) {
  vec2 at = max((gl_FragCoord.xy - contact_origin) * contact_scale, vec2(0.0));
  vec2 part = fract(at);
  ivec2 corner = ivec2(at);
  ivec2 last = textureSize(contact_map, 0) - 1;
  float sum = 0.0;
  float all = 0.0;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      vec2 seen = texelFetch(contact_map, min(corner + ivec2(x, y), last), 0).rg;
      float share = (x == 0 ? 1.0 - part.x : part.x) * (y == 0 ? 1.0 - part.y : part.y);
      float weight = (share + 0.001) / (abs(seen.g - away) + abs(away) * 0.002 + 0.0005);
      sum += seen.r * weight;
      all += weight;
    }
  }
  return sum / all;
}
)";

}  // namespace

const std::string_view kGroundVertex = R"(#version 330 core
uniform mat4 clip_from_relative;
uniform vec3 center_from_eye;
uniform float half_size;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  gl_Position = clip_from_relative * vec4(center_from_eye + vec3(corner * half_size, 0.0), 1.0);
}
)";

const std::string_view kWholeVertex = R"(#version 330 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

const std::string_view kOpennessFragment = R"(#version 330 core
uniform sampler2D depths;
uniform vec4 depth_terms;  // stored depth at s along the view: (x + y s) / (z + w s)
uniform vec2 half_extent;  // of the picture at s = 1, or of the whole picture when orthographic
uniform vec2 center;       // where the line of sight meets the picture, from -1 to 1
uniform bool orthographic;
uniform float reach_m;     // how far surroundings count, as far as they are few or many pixels
out vec4 color;

// A spiral, turned by one of sixteen angles and moved outwards by one of sixteen steps in each
// square of four by four texels, which kEvenedFragment averages.
const int kPlaces = 8;
const vec2 kSpiral[8] = vec2[8](
    vec2(1.000000, 0.000000), vec2(-0.737369, 0.675490), vec2(0.087425, -0.996171),
    vec2(0.608439, 0.793600), vec2(-0.984714, -0.174181), vec2(0.843755, -0.536729),
    vec2(-0.259603, 0.965715), vec2(-0.460908, -0.887448));
const vec2 kTurns[16] = vec2[16](
    vec2(1.0, 0.0), vec2(-1.0, 0.0), vec2(0.707107, 0.707107), vec2(-0.707107, -0.707107),
    vec2(0.0, -1.0), vec2(0.0, 1.0), vec2(0.707107, -0.707107), vec2(-0.707107, 0.707107),
    vec2(0.382683, 0.923880), vec2(-0.382683, -0.923880), vec2(0.923880, 0.382683),
    vec2(-0.923880, -0.382683), vec2(0.923880, -0.382683), vec2(-0.923880, 0.382683),
    vec2(0.382683, -0.923880), vec2(-0.382683, 0.923880));
const float kSteepest = 0.125;  // facets of a round surface keep no light from each other
const float kNothing = 1e9;

ivec2 size;

float awayAt(ivec2 texel) {
  float stored = texelFetch(depths, texel, 0).r;
  if (stored <= 0.0) return kNothing;
  return (depth_terms.x - stored * depth_terms.z) / (stored * depth_terms.w - depth_terms.y);
}
vec3 placeAt(ivec2 texel, float away) {
  vec2 clip = (vec2(texel) + 0.5) * 2.0 / vec2(size) - 1.0;
  return vec3((clip - center) * half_extent * (orthographic ? 1.0 : away), away);
}
// Along the surface from one texel to the next: to the neighbour that lies on it, by its depth.
vec3 alongAt(ivec2 texel, ivec2 way, vec3 place) {
  ivec2 next = min(texel + way, size - 1);
  ivec2 before = max(texel - way, ivec2(0));
  float away_next = next == texel ? kNothing : awayAt(next);
  float away_before = before == texel ? kNothing : awayAt(before);
  if (abs(away_next - place.z) <= abs(away_before - place.z)) {
    return placeAt(next, away_next) - place;
  }
  return place - placeAt(before, away_before);
}

void main() {
  size = textureSize(depths, 0);
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float away = awayAt(texel);
  if (away >= kNothing) {
    color = vec4(1.0, kNothing, 0.0, 1.0);
    return;
  }
  vec3 place = placeAt(texel, away);
  vec3 n = cross(alongAt(texel, ivec2(1, 0), place), alongAt(texel, ivec2(0, 1), place));
  float length2 = dot(n, n);
  n = length2 > 0.0 ? n * (1.0 / sqrt(length2)) : vec3(0.0, 0.0, -1.0);
  if (dot(n, orthographic ? vec3(0.0, 0.0, 1.0) : place) > 0.0) n = -n;

  float texels_a_metre = float(size.y) / (2.0 * half_extent.y * (orthographic ? 1.0 : away));
  float reach = clamp(reach_m * texels_a_metre, max(float(size.y) * 0.02, 2.0),
                      max(float(size.y) * 0.09, 4.0));
  float per_reach = texels_a_metre / reach;
  int pattern = (texel.y & 3) * 4 + (texel.x & 3);
  vec2 turn = kTurns[pattern];
  float inner = (float(pattern) + 0.5) * 0.0625;
  float taken = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    vec2 way = vec2(kSpiral[i].x * turn.x - kSpiral[i].y * turn.y,
                    kSpiral[i].x * turn.y + kSpiral[i].y * turn.x);
    vec2 off = way * ((float(i) + inner) / float(kPlaces) * reach) + way;
    ivec2 there = clamp(texel + ivec2(floor(off + 0.5)), ivec2(0), size - 1);
    vec3 v = (placeAt(there, awayAt(there)) - place) * per_reach;
    float far2 = dot(v, v);
    if (far2 < 1.0 && far2 > 0.0) {
      float rise = dot(v, n) * (1.0 / sqrt(far2));
      taken += max(rise - kSteepest, 0.0) * (1.0 - far2);
    }
  }
  color = vec4(max(1.0 - 3.4 * taken / float(kPlaces), 0.0), away, 0.0, 1.0);
}
)";

// Four texels along a way, from two before to one after: the result lies at the corner before the
// texel's middle, so that after both ways it lies at the texel's whole coordinates.
const std::string_view kEvenedFragment = R"(#version 330 core
uniform sampler2D open;
uniform vec2 along;
out vec4 color;
void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(open, 0) - 1;
  vec2 own = texelFetch(open, texel, 0).rg;
  float sum = 0.0;
  float all = 0.0;
  for (int i = -2; i < 2; ++i) {
    vec2 seen = texelFetch(open, clamp(texel + ivec2(along) * i, ivec2(0), last), 0).rg;
    float weight = 1.0 / (abs(seen.g - own.g) + abs(own.g) * 0.01 + 0.0005);
    sum += seen.r * weight;
    all += weight;
  }
  color = vec4(sum / all, own.g, 0.0, 1.0);
}
)";

std::string withContact(std::string_view source, bool looks_up) {
  std::string text(kFirstLine);
  text += "#define CONTACT\n";
  if (looks_up) text += kLookup;
  text += source.substr(kFirstLine.size());
  return text;
}

}  // namespace rocinante::shader
