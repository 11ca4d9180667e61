#include "viewer/passes/scene_pass.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/math/transform.h"
#include "core/mesh/mesh.h"
#include "viewer/gl/depth_lift.h"
#include "viewer/passes/contact_shaders.h"
#include "viewer/passes/draw_triangles.h"
#include "viewer/passes/item_matrices.h"
#include "viewer/passes/latest_value.h"
#include "viewer/passes/look_shaders.h"
#include "viewer/passes/plain_shader.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {
namespace {

/// Where a blended picture is less opaque than this, its depth is that of what lies behind.
constexpr float kHolesBelow = 0.1F;

/// A white light of strength 1 is as bright as the key light of kSceneFragment at its brightest.
constexpr double kWhiteLight = 0.54;

}  // namespace

/// Sets GL's state for a sequence of items, caching the last values per program.
class ScenePass::Items {
 public:
  Items(const ScenePass& pass, const SceneCatalog& catalog, const MeshBuffers& meshes,
        const TextureStore& textures, const Camera& camera, const CellScene& look,
        const SurfaceLook& surfaces)
      : pass_(pass),
        gl_(pass.gl_),
        catalog_(catalog),
        triangles_(pass.gl_, catalog),
        meshes_(meshes),
        textures_(textures),
        camera_(camera),
        look_(look),
        surfaces_(surfaces),
        plain_(surfaces.shading == Shading::plain),
        variant_(variantOf(surfaces, look)),
        standard_(pass.standardIn(variant_)) {
    if (!surfaces.cutouts || plain_) return;
    Variant with_cutout = variant_;
    with_cutout.cutout = true;
    standard_cutout_ = pass.standardIn(with_cutout);
  }

  /// Whether its texture has transparent pixels.
  bool hasHoles(const DrawItem& item) const {
    const auto texture = static_cast<std::size_t>(item.texture);
    return item.texture >= 0 && textures_.name(texture) != 0 &&
           textures_.translucent()[texture] != 0;
  }

  /// Sets all state for the item. `depth_alone`: no colour, and no depth in a texture's holes.
  void set(const DrawItem& item, bool depth_alone = false) {
    const GLuint texture =
        item.texture >= 0 ? textures_.name(static_cast<std::size_t>(item.texture)) : 0;
    const bool cuts = item.is_cut && texture != 0;
    const Program& program = depth_alone && (cuts || hasHoles(item)) ? *pass_.holes_
                             : !plain_      ? *(cuts ? standard_cutout_ : standard_)
                             : texture == 0 ? *pass_.plain_
                                            : *(cuts ? pass_.plain_cutout_ : pass_.plain_mapped_);
    if (&program != program_) use(program);
    if (mesh_.changesTo(item.mesh)) meshes_.bind(item.mesh);
    if (world_.changesTo(item.world)) setWorld(item.world);
    setMaterial(item, texture);
    if (texture != 0 && texture_.changesTo(texture)) {
      textures_.bind(static_cast<std::size_t>(item.texture));
    }
    if (lift_.changesTo({item.coplanar_rank, item.lift_units})) setLift(item);
  }

  void draw(const DrawItem& item) { triangles_.draw(item); }

  /// Draws as many leading items as possible as one batch; returns their number.
  std::size_t drawBatch(std::span<const DrawItem> items) {
    if (variant_ != Variant() || items.size() < ItemBatch::kLeastItems) return 0;
    if (!items.front().batched) return 0;
    const std::size_t count = ItemBatch::reach(items, catalog_);
    if (count < ItemBatch::kLeastItems) return 0;
    const DrawItem& first = items.front();
    const Program& program = plain_ ? *pass_.batched_plain_ : *pass_.batched_;
    if (&program != program_) use(program);
    setMaterial(first, 0);
    if (lift_.changesTo({first.coplanar_rank, first.lift_units})) setLift(first);
    triangles_.cullFor(first);
    pass_.batch_.draw(items.first(count), catalog_, camera_);
    mesh_ = {};
    return count;
  }

 private:
  void use(const Program& program) {
    program_ = &program;
    world_ = {};
    material_ = {};
    diffuse_ = {};
    has_map_ = {};
    has_tint_ = {};
    cutoff_ = {};
    program.shader.use();
    if (&program == standard_ || &program == standard_cutout_) {
      if (variant_.shadows) bindShadows(gl_, program.shader, *surfaces_.shadows);
      if (variant_.contact) bindContact(gl_, program.shader, *surfaces_.contact);
      for (std::size_t i = 0; i < variant_.lights; ++i) setLight(program.shader, i);
    }
    gl_.Uniform1i(program.orthographic, camera_.orthographic() ? 1 : 0);
    const glm::vec3 forward(camera_.forward());
    gl_.Uniform3f(program.view_direction, forward.x, forward.y, forward.z);
    setDirection(program.key_direction, Vec3(look_.light_direction));
    setDirection(program.fill_direction,
                 camera_.up() * 0.4 - camera_.forward() - camera_.right() * 0.8);
  }

  void setDirection(GLint place, const Vec3& wanted) const {
    const double length = lengthOf(wanted);
    const glm::vec3 unit(length > 0 ? wanted / length : Vec3(0, 0, 1));
    gl_.Uniform3f(place, unit.x, unit.y, unit.z);
  }

  void setLight(const ShaderProgram& shader, std::size_t number) const {
    const CellLight& light = look_.lights[number];
    const std::string place = "[" + std::to_string(number) + "]";
    setDirection(shader.uniform(("light_direction" + place).c_str()), light.direction);
    glm::vec3 color;
    for (int i = 0; i < 3; ++i) {
      // As lightOf() of kSceneFragment.
      const double shown = light.color[i];
      const double linear = shown * (shown * (shown * 0.305306011 + 0.682171111) + 0.012522878);
      color[i] = static_cast<float>(linear * light.strength * kWhiteLight);
    }
    gl_.Uniform3f(shader.uniform(("light_color" + place).c_str()), color.r, color.g, color.b);
  }

  void setWorld(const Mat4& world) const {
    const ItemMatrices matrices(world, camera_);
    gl_.UniformMatrix4fv(program_->clip_from_model, 1, GL_FALSE,
                         glm::value_ptr(matrices.clip_from_model));
    if (program_->relative_from_model >= 0) {  // not in plain shading
      gl_.UniformMatrix4fv(program_->relative_from_model, 1, GL_FALSE,
                           glm::value_ptr(matrices.relative_from_model));
    }
    gl_.UniformMatrix3fv(program_->normal_from_model, 1, GL_FALSE,
                         glm::value_ptr(matrices.normal_from_model));
  }

  void setMaterial(const DrawItem& item, GLuint texture) {
    const Program& program = *program_;
    const glm::vec4& diffuse = item.diffuse;
    if (diffuse_.changesTo(diffuse)) {
      gl_.Uniform4f(program.diffuse, diffuse.r, diffuse.g, diffuse.b, diffuse.a);
    }
    if (has_map_.changesTo(texture != 0 ? 1 : 0)) {
      gl_.Uniform1i(program.has_map, texture != 0 ? 1 : 0);
    }
    if (has_tint_.changesTo(item.tinted ? 1 : 0)) {
      gl_.Uniform1i(program.has_tint, item.tinted ? 1 : 0);
    }
    if (program.cutoff >= 0) {
      const float cutoff = item.is_cut ? item.cutoff : kHolesBelow;
      if (cutoff_.changesTo(cutoff)) gl_.Uniform1f(program.cutoff, cutoff);
    }
    if (!material_.changesTo(item.material)) return;
    const Material& material = *item.material;
    const MapPlacing placing(material);
    gl_.Uniform4f(program.map_along, placing.along_u.x, placing.along_u.y, placing.along_v.x,
                  placing.along_v.y);
    gl_.Uniform2f(program.map_offset, placing.offset.x, placing.offset.y);
    const glm::vec3& specular = material.specular;
    gl_.Uniform3f(program.specular, specular.r, specular.g, specular.b);
    const glm::vec3& emission = material.emission;
    gl_.Uniform3f(program.emission, emission.r, emission.g, emission.b);
    // MTL files often have Ks without Ns: use a broad highlight.
    const float exponent =
        material.shininess > 0 ? std::clamp(material.shininess, 4.0F, 512.0F) : 16;
    gl_.Uniform1f(program.shininess, specular != glm::vec3(0.0F) ? exponent : 0.0F);
  }

  void setLift(const DrawItem& item) const {
    const float ranks = static_cast<float>(item.coplanar_rank) + surfaces_.depth_ranks;
    if (ranks == 0 && item.lift_units == 0) {
      gl_.Disable(GL_POLYGON_OFFSET_FILL);
      return;
    }
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    setDepthLift(gl_, ranks, item.lift_units);
  }

  const ScenePass& pass_;
  const GlTable& gl_;
  const SceneCatalog& catalog_;
  TriangleDrawer triangles_;
  const MeshBuffers& meshes_;
  const TextureStore& textures_;
  const Camera& camera_;
  const CellScene& look_;
  const SurfaceLook& surfaces_;
  bool plain_;
  Variant variant_;
  const Program* standard_;
  const Program* standard_cutout_ = nullptr;
  const Program* program_ = nullptr;
  // Of the program.
  LatestValue<Mat4> world_;
  LatestValue<const Material*> material_;
  LatestValue<glm::vec4> diffuse_;
  LatestValue<int> has_map_, has_tint_;
  LatestValue<float> cutoff_;
  // Of the context.
  LatestValue<std::uint32_t> mesh_;
  LatestValue<std::pair<std::uint32_t, float>> lift_;
  LatestValue<GLuint> texture_;
};

Status ScenePass::finish(ShaderProgram begun, std::optional<Program>& program) {
  if (Status linked = begun.finish(); !linked) return linked;
  Program of{.shader = std::move(begun)};
  const ShaderProgram& shader = of.shader;
  of.clip_from_model = shader.uniform("clip_from_model");
  of.relative_from_model = shader.uniform("relative_from_model");
  of.normal_from_model = shader.uniform("normal_from_model");
  of.map_along = shader.uniform("map_along");
  of.map_offset = shader.uniform("map_offset");
  of.diffuse = shader.uniform("diffuse");
  of.specular = shader.uniform("specular");
  of.emission = shader.uniform("emission");
  of.shininess = shader.uniform("shininess");
  of.has_map = shader.uniform("has_map");
  of.has_tint = shader.uniform("has_tint");
  of.cutoff = shader.uniform("cutoff");
  of.orthographic = shader.uniform("orthographic");
  of.view_direction = shader.uniform("view_direction");
  of.key_direction = shader.uniform("key_direction");
  of.fill_direction = shader.uniform("fill_direction");
  program = std::move(of);
  return {};
}

ShaderProgram ScenePass::begin(std::string_view name, std::string_view vertex,
                               std::string_view fragment) const {
  return ShaderProgram::begin(gl_, name, vertex, fragment);
}

ScenePass::ScenePass(const GlTable& gl) : gl_(gl), batch_(gl) {
  using namespace shader;
  begun_.emplace(Begun{
      begin("plain scene", kPlainVertex, kPlainFragment),
      begin("plain scene with pictures", kPlainVertex, kPlainMappedFragment),
      begin("small items, plain", kBatchedPlainVertex, kPlainFragment),
  });
}

Status ScenePass::preparePlain() {
  if (!begun_) return {};
  Begun begun = std::move(*begun_);
  begun_.reset();
  if (Status linked = finish(std::move(begun.plain), plain_); !linked) return linked;
  if (Status linked = finish(std::move(begun.mapped), plain_mapped_); !linked) return linked;
  return finish(std::move(begun.batched), batched_plain_);
}

Status ScenePass::prepareStandard() {
  if (standard_) return {};
  using namespace shader;
  ShaderProgram standard = begin("scene", kSceneVertex, kSceneFragment);
  ShaderProgram batched = begin("small items", kBatchedVertex, kSceneFragment);
  if (Status linked = finish(std::move(batched), batched_); !linked) return linked;
  return finish(std::move(standard), standard_);
}

Status ScenePass::prepareHoles() {
  if (holes_) return {};
  using namespace shader;
  return finish(begin("depth of pictures with holes", kSceneVertex, kHolesFragment), holes_);
}

Status ScenePass::preparePlainCutout() {
  if (plain_cutout_) return {};
  using namespace shader;
  return finish(
      begin("plain scene with cut pictures", kPlainVertex, withCutout(kPlainMappedFragment)),
      plain_cutout_);
}

ScenePass::Variant ScenePass::variantOf(const SurfaceLook& surfaces, const CellScene& look) {
  if (surfaces.shading == Shading::plain) return {};
  return {surfaces.shadows != nullptr, surfaces.contact != nullptr, look.lights.size(), false};
}

const ScenePass::Program* ScenePass::standardIn(const Variant& variant) const {
  if (variant == Variant()) return standard_ ? &*standard_ : nullptr;
  const auto found = variants_.find(variant);
  assert(found != variants_.end());
  return &*found->second;
}

Status ScenePass::prepare(const SurfaceLook& surfaces, const CellScene& look) {
  if (surfaces.holes || surfaces.cutouts) {
    if (Status ready = prepareHoles(); !ready) return ready;
  }
  Variant variant = variantOf(surfaces, look);
  if (surfaces.cutouts) {
    variant.cutout = true;
    const bool is_plain = surfaces.shading == Shading::plain;
    Status ready = is_plain ? preparePlainCutout() : prepareVariant(variant);
    if (!ready) return ready;
    variant.cutout = false;
  }
  if (surfaces.shading == Shading::plain) return preparePlain();
  if (variant == Variant()) return prepareStandard();
  return prepareVariant(variant);
}

Status ScenePass::prepareVariant(const Variant& variant) {
  if (variants_.contains(variant)) return {};
  std::string fragment = shader::withLights(shader::kSceneFragment, variant.lights);
  if (variant.contact) fragment = shader::withContact(fragment, true);
  if (variant.shadows) fragment = shader::withShadows(fragment, true);
  if (variant.cutout) fragment = shader::withCutout(fragment);
  std::optional<Program> made;
  if (Status linked = finish(begin("scene with looks", shader::kSceneVertex, fragment), made);
      !linked)
    return linked;
  variants_.emplace(variant, std::move(made));
  return {};
}

void ScenePass::drawOpaque(const DrawList& list, const SceneCatalog& catalog,
                           const MeshBuffers& meshes, const TextureStore& textures,
                           const Camera& camera, const CellScene& look,
                           const SurfaceLook& surfaces) const {
  gl_.Enable(GL_DEPTH_TEST);
  const GLboolean shown = surfaces.depth_only ? GL_FALSE : GL_TRUE;
  // Write alpha too, which is 1 here, so that a software renderer need not read the old pixels.
  gl_.ColorMask(shown, shown, shown, shown);
  Items items(*this, catalog, meshes, textures, camera, look, surfaces);
  const std::span opaque(list.opaque);
  for (std::size_t i = 0; i < opaque.size();) {
    const std::size_t batched = items.drawBatch(opaque.subspan(i));
    i += batched;
    if (batched > 0) continue;
    items.set(opaque[i]);
    items.draw(opaque[i]);
    ++i;
  }
  if (surfaces.depth_only) {
    for (const DrawItem& item : list.translucent) {
      items.set(item, true);
      items.draw(item);
    }
  }
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void ScenePass::drawTranslucent(std::span<const DrawItem> translucent, const SceneCatalog& catalog,
                                const MeshBuffers& meshes, const TextureStore& textures,
                                const Camera& camera, const CellScene& look,
                                const SurfaceLook& surfaces) const {
  if (translucent.empty()) return;
  gl_.Enable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  Items items(*this, catalog, meshes, textures, camera, look, surfaces);
  for (const DrawItem& item : translucent) {
    items.set(item, true);
    // Depth first, so that only the nearest surface of each part shows: otherwise back sides would
    // depend on the triangle order. In the second pass holes must not write depth either.
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    items.draw(item);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    items.set(item);
    gl_.DepthMask(items.hasHoles(item) ? GL_FALSE : GL_TRUE);
    items.draw(item);
  }
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
}

}  // namespace rocinante
