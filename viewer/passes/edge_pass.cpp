#include "viewer/passes/edge_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "viewer/cull/cull_sphere.h"
#include "viewer/passes/look_shaders.h"

namespace rocinante {
namespace {

/// Edges per row of their texture, and texels per edge.
constexpr int kEdgesInRow = 1024;
constexpr int kMaxRows = 8192;
constexpr int kTexels = 4;

}  // namespace

Result<EdgePass> EdgePass::create(const GlTable& gl) {
  auto program = ShaderProgram::link(gl, "edge", shader::kEdgeVertex, shader::kEdgeFragment);
  if (!program) return program.error();
  return EdgePass(gl, std::move(*program));
}

EdgePass::EdgePass(const GlTable& gl, ShaderProgram program)
    : gl_(gl), program_(std::move(program)) {
  uniforms_.clip_from_model = program_.uniform("clip_from_model");
  uniforms_.eye = program_.uniform("eye");
  uniforms_.first_edge = program_.uniform("first_edge");
  uniforms_.every_edge = program_.uniform("every_edge");
  uniforms_.color = program_.uniform("flat_color");
  uniforms_.viewport = program_.uniform("viewport");
  uniforms_.near = program_.uniform("near");
  uniforms_.lift = program_.uniform("lift");
  uniforms_.low = program_.uniform("low");
  uniforms_.alone = program_.uniform("alone");
  uniforms_.unit_px = program_.uniform("unit_px");
}

const EdgePass::Edges& EdgePass::edgesOf(const Mesh& mesh) {
  const auto [place, is_new] = edges_.try_emplace(&mesh);
  if (!is_new) return place->second;
  MeshEdges found = meshEdges(mesh);
  const auto rows = static_cast<int>(
      std::min<std::size_t>((found.edges.size() + kEdgesInRow - 1) / kEdgesInRow, kMaxRows));
  const std::size_t room = static_cast<std::size_t>(rows) * kEdgesInRow;
  // Beyond eight million edges, lines of the last parts are left out.
  for (PartEdges& part : found.parts) {
    const std::size_t left = room > part.first ? room - part.first : 0;
    part.all = static_cast<std::uint32_t>(std::min<std::size_t>(part.all, left));
    part.features = std::min(part.features, part.all);
  }
  std::vector<glm::vec4> texels(room * kTexels);
  for (std::size_t i = 0; i < std::min(found.edges.size(), room); ++i) {
    const MeshEdge& edge = found.edges[i];
    glm::vec4* const to = texels.data() + i * kTexels;
    to[0] = glm::vec4(edge.a, edge.first_normal.x);
    to[1] = glm::vec4(edge.b, edge.first_normal.y);
    to[2] = glm::vec4(edge.second_normal, edge.first_normal.z);
    to[3] = glm::vec4(edge.face_width, 0, 0, 0);
  }
  place->second.parts = std::move(found.parts);
  if (rows == 0) return place->second;
  place->second.texture = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, place->second.texture);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kEdgesInRow * kTexels, rows, 0, GL_RGBA, GL_FLOAT,
                 texels.data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return place->second;
}

void EdgePass::setItem(const DrawItem& item, const Camera& camera) const {
  const Mat4 relative = camera.relative(item.world);
  const glm::mat4 clip_from_model(camera.clipFromRelative() * relative);
  gl_.UniformMatrix4fv(uniforms_.clip_from_model, 1, GL_FALSE, glm::value_ptr(clip_from_model));
  // Outlines are found in model space, which works for any scale except a flat one.
  glm::vec4 eye(0, 0, 0, 0);
  if (glm::determinant(glm::dmat3(relative)) != 0) {
    const glm::dmat4 model = glm::affineInverse(glm::dmat4(relative));
    const Vec3 forward = camera.forward();
    eye = glm::vec4(camera.orthographic() ? model * glm::dvec4(-forward, 0)
                                          : model * glm::dvec4(0, 0, 0, 1));
  }
  gl_.Uniform4f(uniforms_.eye, eye.x, eye.y, eye.z, eye.w);
}

void EdgePass::draw(const std::vector<DrawItem>& items, const SceneCatalog& catalog,
                    const Camera& camera, double scale, EdgeChoice choice,
                    const ColorOf& color_of) {
  if (items.empty()) return;
  gl_.Enable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BindVertexArray(empty_array_);
  program_.use();
  const bool zero_to_one = gl_.ClipControl != nullptr;
  // The shader has widths in pixels of scale 1.
  gl_.Uniform2f(uniforms_.viewport, static_cast<float>(camera.width() / scale),
                static_cast<float>(camera.height() / scale));
  gl_.Uniform1f(uniforms_.near, camera.orthographic() ? 0.5F : static_cast<float>(camera.near()));
  gl_.Uniform1f(uniforms_.low, zero_to_one ? 0 : 1);
  gl_.Uniform1i(uniforms_.every_edge, choice == EdgeChoice::all ? 1 : 0);
  gl_.Uniform1i(uniforms_.alone, choice == EdgeChoice::features_alone ? 1 : 0);
  // Nearer by a ten-thousandth of the distance; for an orthographic camera, by the width of a
  // pixel.
  constexpr double kEdgeLift = 1e-4;
  const glm::dvec4 axis(camera.forward(), 0);
  const double depth_a_metre =
      -(glm::dmat4(camera.clipFromRelative()) * axis).z * (zero_to_one ? 1 : 0.5);
  const glm::vec2 lift(
      camera.orthographic() ? 0 : static_cast<float>(kEdgeLift),
      camera.orthographic() ? static_cast<float>(depth_a_metre * camera.metersPerPixel(0)) : 0);
  // At a depth of one metre; without perspective at any.
  const double metre_px = 1 / (camera.metersPerPixel(1) * scale);
  for (const DrawItem& item : items) {
    const Edges& edges = edgesOf(*catalog.meshes()[item.mesh].mesh);
    const PartEdges& part = edges.parts[item.part];
    const std::uint32_t count = choice == EdgeChoice::all ? part.all : part.features;
    if (count == 0) continue;
    gl_.BindTexture(GL_TEXTURE_2D, edges.texture);
    setItem(item, camera);
    // For a uniform scale the bound is the scale times the square root of three.
    gl_.Uniform1f(uniforms_.unit_px,
                  static_cast<float>(scaleBound(item.world) / std::sqrt(3.0) * metre_px));
    const glm::vec4 shade = color_of(item);
    gl_.Uniform4f(uniforms_.color, shade.r, shade.g, shade.b, shade.a);
    // Lifted with their surface; a unit is at most this much depth.
    const float more = item.lift_units * (camera.orthographic() ? 0x1p-24F : 0x1p-23F);
    gl_.Uniform2f(uniforms_.lift, lift.x + (camera.orthographic() ? 0 : more),
                  lift.y + (camera.orthographic() ? more : 0));
    gl_.Uniform1i(uniforms_.first_edge, static_cast<GLint>(part.first));
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count * 6));
  }
  gl_.Disable(GL_BLEND);
}

}  // namespace rocinante
