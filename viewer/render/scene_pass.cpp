#include "viewer/render/scene_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "core/math/transform.h"
#include "viewer/render/depth_lift.h"
#include "viewer/render/draw_triangles.h"
#include "viewer/render/shader_source.h"

namespace rocinante {
namespace {

/// Inverse transpose, but for a factor: enough for normals, which are made unit length later.
glm::mat3 normalMatrix(const Mat4& m) {
  const Vec3 x(m[0]);
  const Vec3 y(m[1]);
  const Vec3 z(m[2]);
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  };
  const std::array columns{cross(y, z), cross(z, x), cross(x, y)};
  // Scaled to about one, because a float cannot hold the squares of very small scales.
  double largest = 0;
  for (const Vec3& column : columns) {
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(column[i]));
  }
  const double scale = largest > 0 ? 1 / largest : 1;
  return {glm::vec3(columns[0] * scale), glm::vec3(columns[1] * scale),
          glm::vec3(columns[2] * scale)};
}

}  // namespace

Result<ScenePass> ScenePass::create(const GlTable& gl) {
  auto program = ShaderProgram::link(gl, "scene", shader::kSceneVertex, shader::kSceneFragment);
  if (!program) return program.error();
  return ScenePass(gl, std::move(*program));
}

ScenePass::ScenePass(const GlTable& gl, ShaderProgram program)
    : gl_(gl), program_(std::move(program)) {
  uniforms_.clip_from_model = program_.uniform("clip_from_model");
  uniforms_.relative_from_model = program_.uniform("relative_from_model");
  uniforms_.normal_from_model = program_.uniform("normal_from_model");
  uniforms_.map_scale = program_.uniform("map_scale");
  uniforms_.map_offset = program_.uniform("map_offset");
  uniforms_.diffuse = program_.uniform("diffuse");
  uniforms_.specular = program_.uniform("specular");
  uniforms_.emission = program_.uniform("emission");
  uniforms_.shininess = program_.uniform("shininess");
  uniforms_.has_map = program_.uniform("has_map");
  uniforms_.has_tint = program_.uniform("has_tint");
  uniforms_.orthographic = program_.uniform("orthographic");
  uniforms_.view_direction = program_.uniform("view_direction");
  uniforms_.key_direction = program_.uniform("key_direction");
  uniforms_.fill_direction = program_.uniform("fill_direction");
}

void ScenePass::setScene(const Camera& camera, const CellScene& look) const {
  gl_.Enable(GL_DEPTH_TEST);
  program_.use();
  gl_.Uniform1i(uniforms_.orthographic, camera.orthographic() ? 1 : 0);
  const glm::vec3 forward(camera.forward());
  gl_.Uniform3f(uniforms_.view_direction, forward.x, forward.y, forward.z);
  const auto setDirection = [&](GLint place, const Vec3& wanted) {
    const double length =
        std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y + wanted.z * wanted.z);
    const glm::vec3 unit(length > 0 ? wanted / length : Vec3(0, 0, 1));
    gl_.Uniform3f(place, unit.x, unit.y, unit.z);
  };
  setDirection(uniforms_.key_direction, Vec3(look.light_direction));
  setDirection(uniforms_.fill_direction,
               camera.up() * 0.4 - camera.forward() - camera.right() * 0.8);
}

void ScenePass::setItem(const DrawItem& item, const TextureStore& textures,
                        const Camera& camera) const {
  const Mat4 relative = camera.relative(item.world);
  const glm::mat4 clip_from_model(camera.clipFromRelative() * relative);
  const glm::mat4 relative_from_model(relative);
  const glm::mat3 normal_from_model = normalMatrix(relative);
  gl_.UniformMatrix4fv(uniforms_.clip_from_model, 1, GL_FALSE, glm::value_ptr(clip_from_model));
  gl_.UniformMatrix4fv(uniforms_.relative_from_model, 1, GL_FALSE,
                       glm::value_ptr(relative_from_model));
  gl_.UniformMatrix3fv(uniforms_.normal_from_model, 1, GL_FALSE, glm::value_ptr(normal_from_model));

  const Material& material = *item.material;
  gl_.Uniform2f(uniforms_.map_scale, material.map_scale.x, material.map_scale.y);
  gl_.Uniform2f(uniforms_.map_offset, material.map_offset.x, material.map_offset.y);
  gl_.Uniform4f(uniforms_.diffuse, item.diffuse.r, item.diffuse.g, item.diffuse.b, item.diffuse.a);
  gl_.Uniform3f(uniforms_.specular, material.specular.r, material.specular.g, material.specular.b);
  gl_.Uniform3f(uniforms_.emission, material.emission.r, material.emission.g, material.emission.b);
  const bool shines = material.specular != glm::vec3(0.0F);
  // MTL files often say Ks without Ns: a broad highlight then.
  const float exponent = material.shininess > 0 ? std::clamp(material.shininess, 4.0F, 512.0F) : 16;
  gl_.Uniform1f(uniforms_.shininess, shines ? exponent : 0.0F);
  const GLuint texture =
      item.texture >= 0 ? textures.name(static_cast<std::size_t>(item.texture)) : 0;
  gl_.Uniform1i(uniforms_.has_map, texture != 0 ? 1 : 0);
  gl_.Uniform1i(uniforms_.has_tint, item.tinted ? 1 : 0);
  if (texture != 0) gl_.BindTexture(GL_TEXTURE_2D, texture);

  if (item.coplanar_rank > 0) {
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    setDepthLift(gl_, static_cast<float>(item.coplanar_rank));
  } else {
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
  }
}

void ScenePass::drawOpaque(const DrawList& list, const SceneCatalog& catalog,
                           const MeshBuffers& meshes, const TextureStore& textures,
                           const Camera& camera, const CellScene& look) const {
  setScene(camera, look);
  for (const DrawItem& item : list.opaque) {
    meshes.bind(item.mesh);
    setItem(item, textures, camera);
    drawTriangles(gl_, item, catalog);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void ScenePass::drawTranslucent(const DrawList& list, const SceneCatalog& catalog,
                                const MeshBuffers& meshes, const TextureStore& textures,
                                const Camera& camera, const CellScene& look) const {
  if (list.translucent.empty()) return;
  setScene(camera, look);
  gl_.Enable(GL_BLEND);
  for (const DrawItem& item : list.translucent) {
    meshes.bind(item.mesh);
    setItem(item, textures, camera);
    // Depth first, so that of each part only the nearest surface shows: its back sides would come
    // and go with the order of its triangles.
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawTriangles(gl_, item, catalog);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    drawTriangles(gl_, item, catalog);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
}

}  // namespace rocinante
