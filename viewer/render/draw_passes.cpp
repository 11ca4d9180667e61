#include "viewer/render/draw_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>

#include "core/math/transform.h"
#include "viewer/render/shader_source.h"

namespace rocinante {
namespace {

/// Depth grows towards the eye, so a positive offset lifts: a tenth of the surface's slope across a
/// pixel covers the rounding of its corners to 1/256 pixel; the units cover that of the depth.
constexpr float kLiftSlope = 0.1F;
constexpr float kLiftUnits = 64.0F;

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

Result<std::unique_ptr<DrawPasses>> DrawPasses::create(const GlTable& gl, const TextAtlas& atlas) {
  using namespace shader;
  auto scene = ShaderProgram::link(gl, "scene", kSceneVertex, kSceneFragment);
  if (!scene) return scene.error();
  auto background = ShaderProgram::link(gl, "background", kBackgroundVertex, kBackgroundFragment);
  if (!background) return background.error();
  auto grid = ShaderProgram::link(gl, "grid", kGridVertex, kGridFragment);
  if (!grid) return grid.error();
  auto overlay = ShaderProgram::link(gl, "overlay", kOverlayVertex, kOverlayFragment);
  if (!overlay) return overlay.error();
  return std::unique_ptr<DrawPasses>(new DrawPasses(gl, std::move(*scene), std::move(*background),
                                                    std::move(*grid), std::move(*overlay), atlas));
}

DrawPasses::DrawPasses(const GlTable& gl, ShaderProgram scene, ShaderProgram background,
                       ShaderProgram grid, ShaderProgram overlay, const TextAtlas& atlas)
    : gl_(gl),
      scene_(std::move(scene)),
      background_(std::move(background)),
      grid_(std::move(grid)),
      overlay_(std::move(overlay)) {
  uniforms_.clip_from_model = scene_.uniform("clip_from_model");
  uniforms_.relative_from_model = scene_.uniform("relative_from_model");
  uniforms_.normal_from_model = scene_.uniform("normal_from_model");
  uniforms_.map_scale = scene_.uniform("map_scale");
  uniforms_.map_offset = scene_.uniform("map_offset");
  uniforms_.diffuse = scene_.uniform("diffuse");
  uniforms_.specular = scene_.uniform("specular");
  uniforms_.emission = scene_.uniform("emission");
  uniforms_.shininess = scene_.uniform("shininess");
  uniforms_.has_map = scene_.uniform("has_map");
  uniforms_.has_tint = scene_.uniform("has_tint");
  uniforms_.orthographic = scene_.uniform("orthographic");
  uniforms_.view_direction = scene_.uniform("view_direction");
  uniforms_.key_direction = scene_.uniform("key_direction");
  uniforms_.fill_direction = scene_.uniform("fill_direction");

  gl_.GenVertexArrays(1, &empty_array_);

  gl_.GenVertexArrays(1, &grid_array_);
  gl_.BindVertexArray(grid_array_);
  gl_.GenBuffers(1, &grid_vertices_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, grid_vertices_);
  constexpr std::array<float, 8> kCorners{-1, -1, 1, -1, -1, 1, 1, 1};
  gl_.BufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners.data(), GL_STATIC_DRAW);
  gl_.EnableVertexAttribArray(0);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);

  gl_.GenVertexArrays(1, &overlay_array_);
  gl_.BindVertexArray(overlay_array_);
  gl_.GenBuffers(1, &overlay_vertices_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, overlay_vertices_);
  for (GLuint place = 0; place < 4; ++place) gl_.EnableVertexAttribArray(place);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei kStride = sizeof(OverlayVertex);
  gl_.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(OverlayVertex, clip)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride,
                          offset(offsetof(OverlayVertex, texture)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          offset(offsetof(OverlayVertex, abgr)));
  gl_.VertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, offset(offsetof(OverlayVertex, kind)));
  gl_.BindVertexArray(0);

  gl_.GenTextures(1, &atlas_texture_);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.width(), atlas.height(), 0, GL_RED,
                 GL_UNSIGNED_BYTE, atlas.coverage().data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

DrawPasses::~DrawPasses() {
  for (const GLuint array : {empty_array_, grid_array_, overlay_array_}) {
    gl_.DeleteVertexArrays(1, &array);
  }
  for (const GLuint buffer : {grid_vertices_, overlay_vertices_}) gl_.DeleteBuffers(1, &buffer);
  gl_.DeleteTextures(1, &atlas_texture_);
}

void DrawPasses::begin() const {
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.DepthMask(GL_TRUE);
  gl_.ClearColor(0, 0, 0, 1);
  gl_.ClearDepth(0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  // A frame is opaque, whatever is blended into it.
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  // What is drawn later wins where depths are equal: the order of drawing is fixed.
  gl_.DepthFunc(GL_GEQUAL);
}

void DrawPasses::drawBackground(const CellScene& look) const {
  gl_.Disable(GL_DEPTH_TEST);
  background_.use();
  const glm::vec3& top = look.background_top;
  const glm::vec3& bottom = look.background_bottom;
  gl_.Uniform3f(background_.uniform("top"), top.x, top.y, top.z);
  gl_.Uniform3f(background_.uniform("bottom"), bottom.x, bottom.y, bottom.z);
  gl_.BindVertexArray(empty_array_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void DrawPasses::setScene(const Camera& camera, const CellScene& look) const {
  gl_.Enable(GL_DEPTH_TEST);
  scene_.use();
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

void DrawPasses::setItem(const DrawItem& item, const TextureStore& textures,
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
    const auto rank = static_cast<float>(item.coplanar_rank);
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(kLiftSlope * rank, kLiftUnits * rank);
  } else {
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
  }
}

void DrawPasses::drawItem(const DrawItem& item, const SceneCatalog& catalog) const {
  const CatalogMesh& mesh = catalog.meshes()[item.mesh];
  const MeshPart& part = mesh.mesh->parts[item.part];
  const std::uint32_t one_sided = mesh.parts[item.part].one_sided_count;
  const std::uint32_t two_sided = part.index_count - one_sided;
  const auto drawRun = [&](std::uint32_t first, std::uint32_t count) {
    const std::size_t offset = std::size_t{first} * sizeof(std::uint32_t);
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(offset));
  };
  if (two_sided > 0) drawRun(part.first_index, two_sided);
  if (one_sided > 0) {
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_BACK);
    gl_.FrontFace(item.mirrored ? GL_CW : GL_CCW);
    drawRun(part.first_index + two_sided, one_sided);
    gl_.Disable(GL_CULL_FACE);
  }
}

void DrawPasses::drawOpaque(const DrawList& list, const SceneCatalog& catalog,
                            const MeshBuffers& meshes, const TextureStore& textures,
                            const Camera& camera, const CellScene& look) const {
  setScene(camera, look);
  for (const DrawItem& item : list.opaque) {
    meshes.bind(item.mesh);
    setItem(item, textures, camera);
    drawItem(item, catalog);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void DrawPasses::drawTranslucent(const DrawList& list, const SceneCatalog& catalog,
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
    drawItem(item, catalog);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    drawItem(item, catalog);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
}

void DrawPasses::drawGrid(const Camera& camera, const CellScene& look) const {
  if (!(look.grid_size_m > 0) || !(look.grid_step_m > 0)) return;
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  // Floors that lie on the ground hide it.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(-kLiftSlope, -kLiftUnits);
  grid_.use();
  const glm::mat4 clip(camera.clipFromRelative());
  gl_.UniformMatrix4fv(grid_.uniform("clip_from_relative"), 1, GL_FALSE, glm::value_ptr(clip));
  const glm::vec3 center(-camera.eye());
  gl_.Uniform3f(grid_.uniform("center_from_eye"), center.x, center.y, center.z);
  gl_.Uniform1f(grid_.uniform("half_size"), static_cast<float>(look.grid_size_m));
  gl_.Uniform1f(grid_.uniform("grid_step"), static_cast<float>(look.grid_step_m));
  gl_.BindVertexArray(grid_array_);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
}

void DrawPasses::drawVertices(const Overlay& overlay) const {
  const auto& vertices = overlay.vertices();
  overlay_.use();
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.BindVertexArray(overlay_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, overlay_vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(OverlayVertex)),
                 vertices.data(), GL_STREAM_DRAW);
  gl_.Enable(GL_BLEND);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  gl_.Disable(GL_BLEND);
}

void DrawPasses::drawInScene(const Overlay& overlay) const {
  if (overlay.vertices().empty()) return;
  gl_.Enable(GL_DEPTH_TEST);
  drawVertices(overlay);
}

void DrawPasses::drawOnTop(const Overlay& overlay) const {
  if (overlay.vertices().empty()) return;
  gl_.Disable(GL_DEPTH_TEST);
  drawVertices(overlay);
}

void DrawPasses::end() const {
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.ClearDepth(1);
  gl_.BindVertexArray(0);
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.UseProgram(0);
  if (gl_.ClipControl != nullptr) gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace rocinante
