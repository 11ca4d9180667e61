#include "tests/bench/render/bare_loop.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>

#include "core/cell/posed_scene.h"
#include "viewer/gl/depth_lift.h"
#include "viewer/passes/plain_shader.h"
#include "viewer/passes/shader_source.h"

namespace rocinante::bench {
namespace {

glm::vec3 unitOf(const Vec3& direction) { return glm::vec3(direction / lengthOf(direction)); }

}  // namespace

struct BareLoop::Scene {
  struct Places {
    GLint clip, relative, normal, along, offset, diffuse, specular, emission, shininess, map, tint;
  };
  Scene(const GlTable& gl, const Cell& cell, BackgroundPass pass)
      : catalog(cell),
        meshes(gl, catalog, inputs),
        textures(gl, catalog.textures(), Profile::reproducible, inputs),
        look(cell.scene),
        background(std::move(pass)) {}

  SceneCatalog catalog;
  InputsHash inputs;
  MeshBuffers meshes;
  TextureStore textures;
  CellScene look;
  BackgroundPass background;
  std::vector<ShaderProgram> programs;
  std::vector<Places> places;
};

BareLoop::BareLoop(const GlTable& gl, std::shared_ptr<Scene> scene)
    : gl_(gl), scene_(std::move(scene)) {}

Result<BareLoop> BareLoop::create(const GlTable& gl, const Cell& cell, const PosedScene& scene,
                                  const CameraView& view, int width, int height, Shading shading,
                                  DrawOrder order) {
  using namespace shader;
  BackgroundPass background(gl);
  if (Status ready = background.prepare(); !ready) return ready.error();
  auto made = std::make_shared<Scene>(gl, cell, std::move(background));
  const bool plain = shading == Shading::plain;
  for (const auto& [vertex, fragment] : {std::pair(kSceneVertex, kSceneFragment),
                                         {kPlainVertex, kPlainFragment},
                                         {kPlainVertex, kPlainMappedFragment}}) {
    auto program = ShaderProgram::link(gl, "bare", vertex, fragment);
    if (!program) return program.error();
    const ShaderProgram& p = *program;
    made->places.push_back({p.uniform("clip_from_model"), p.uniform("relative_from_model"),
                            p.uniform("normal_from_model"), p.uniform("map_along"),
                            p.uniform("map_offset"), p.uniform("diffuse"), p.uniform("specular"),
                            p.uniform("emission"), p.uniform("shininess"), p.uniform("has_map"),
                            p.uniform("has_tint")});
    made->programs.push_back(std::move(*program));
  }
  const Camera camera(view, width, height, ClipDepth::zero_to_one, 1000);
  const auto choice = ViewChoice::make({}, {});
  DrawList list = makeDrawList(scene, made->catalog, *choice, camera, made->textures.translucent());

  if (order == DrawOrder::of_model) {
    std::ranges::stable_sort(list.opaque, {}, [](const DrawItem& item) {
      return std::tuple(item.device, item.link, item.mesh, item.part);
    });
  }

  BareLoop loop(gl, made);
  loop.key_ = unitOf(Vec3(cell.scene.light_direction));
  loop.fill_ = unitOf(camera.up() * 0.4 - camera.forward() - camera.right() * 0.8);
  loop.forward_ = glm::vec3(camera.forward());
  loop.orthographic_ = camera.orthographic();
  const DrawItem* last = nullptr;
  for (const auto* items : {&list.opaque, &list.translucent}) {
    for (const DrawItem& item : *items) {
      Command command;
      const Mat4 relative = camera.relative(item.world);
      command.clip = glm::mat4(camera.clipFromRelative() * relative);
      command.relative = glm::mat4(relative);
      command.normal = glm::mat3(glm::inverseTranspose(glm::dmat3(relative)));
      command.mesh = item.mesh;
      command.diffuse = item.diffuse;
      const Material& material = *item.material;
      command.specular = material.specular;
      command.emission = material.emission;
      command.placing = MapPlacing(material);
      const bool shines = material.specular != glm::vec3(0.0F);
      const float exponent =
          material.shininess > 0 ? std::clamp(material.shininess, 4.0F, 512.0F) : 16;
      command.shininess = shines ? exponent : 0;
      command.texture =
          item.texture < 0 ? 0 : made->textures.name(static_cast<std::size_t>(item.texture));
      command.program = !plain ? 0U : command.texture == 0 ? 1U : 2U;
      command.tinted = item.tinted;
      command.rank = item.coplanar_rank;
      command.translucent = items == &list.translucent;
      const CatalogMesh& mesh = made->catalog.meshes()[item.mesh];
      const MeshPart& part = mesh.mesh->parts[item.part];
      const std::uint32_t one_sided = mesh.parts[item.part].one_sided_count;
      if (part.index_count > one_sided) {
        command.runs.push_back({part.first_index, part.index_count - one_sided, false, false});
      }
      if (one_sided > 0) {
        command.runs.push_back(
            {part.first_index + part.index_count - one_sided, one_sided, true, item.mirrored});
      }
      const bool other_program =
          last == nullptr || command.program != loop.commands_.back().program;
      command.sets_program = other_program;
      command.sets_mesh = last == nullptr || item.mesh != last->mesh;
      command.sets_world = other_program || item.world != last->world;
      command.sets_material = other_program || item.material != last->material ||
                              item.diffuse != last->diffuse || item.texture != last->texture ||
                              item.tinted != last->tinted;
      command.sets_lift = last == nullptr || item.coplanar_rank != last->coplanar_rank;
      loop.commands_.push_back(std::move(command));
      last = &item;
    }
  }
  return loop;
}

void BareLoop::useProgram(std::size_t number) const {
  const ShaderProgram& program = scene_->programs[number];
  program.use();
  gl_.Uniform1i(program.uniform("orthographic"), orthographic_ ? 1 : 0);
  gl_.Uniform3f(program.uniform("view_direction"), forward_.x, forward_.y, forward_.z);
  gl_.Uniform3f(program.uniform("key_direction"), key_.x, key_.y, key_.z);
  gl_.Uniform3f(program.uniform("fill_direction"), fill_.x, fill_.y, fill_.z);
}

void BareLoop::set(const Command& c) const {
  if (c.sets_program) useProgram(c.program);
  const Scene::Places& at = scene_->places[c.program];
  if (c.sets_mesh) scene_->meshes.bind(c.mesh);
  if (c.sets_world) {
    gl_.UniformMatrix4fv(at.clip, 1, GL_FALSE, glm::value_ptr(c.clip));
    if (c.program == 0) {
      gl_.UniformMatrix4fv(at.relative, 1, GL_FALSE, glm::value_ptr(c.relative));
    }
    gl_.UniformMatrix3fv(at.normal, 1, GL_FALSE, glm::value_ptr(c.normal));
  }
  if (c.sets_material) {
    gl_.Uniform4f(at.diffuse, c.diffuse.r, c.diffuse.g, c.diffuse.b, c.diffuse.a);
    gl_.Uniform3f(at.emission, c.emission.r, c.emission.g, c.emission.b);
    gl_.Uniform4f(at.along, c.placing.along_u.x, c.placing.along_u.y, c.placing.along_v.x,
                  c.placing.along_v.y);
    gl_.Uniform2f(at.offset, c.placing.offset.x, c.placing.offset.y);
    gl_.Uniform1i(at.tint, c.tinted ? 1 : 0);
    if (c.program == 0) {
      gl_.Uniform3f(at.specular, c.specular.r, c.specular.g, c.specular.b);
      gl_.Uniform1f(at.shininess, c.shininess);
      gl_.Uniform1i(at.map, c.texture != 0 ? 1 : 0);
    }
    if (c.texture != 0) gl_.BindTexture(GL_TEXTURE_2D, c.texture);
  }
  if (c.sets_lift) {
    if (c.rank > 0) {
      gl_.Enable(GL_POLYGON_OFFSET_FILL);
      setDepthLift(gl_, static_cast<float>(c.rank));
    } else {
      gl_.Disable(GL_POLYGON_OFFSET_FILL);
    }
  }
}

void BareLoop::drawRuns(const Command& command) const {
  for (const Run& run : command.runs) {
    if (run.one_sided) {
      gl_.Enable(GL_CULL_FACE);
      gl_.CullFace(GL_BACK);
      gl_.FrontFace(run.mirrored ? GL_CW : GL_CCW);
    }
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(std::size_t{run.first} * 4));
    if (run.one_sided) gl_.Disable(GL_CULL_FACE);
  }
}

void BareLoop::draw(const FrameBuffer& target) const {
  target.bind();
  scene_->background.draw(scene_->look, {0, 0, target.width(), target.height()}, target.height());
  gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.ClearDepth(0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.DepthFunc(GL_GEQUAL);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_DEPTH_TEST);
  if (commands_.front().program != 0) scene_->textures.beginPlainFiltering();
  for (const Command& command : commands_) {
    set(command);
    if (command.translucent) {
      gl_.Enable(GL_BLEND);
      gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      drawRuns(command);
      gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    }
    drawRuns(command);
  }
  scene_->textures.endPlainFiltering();
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.BindVertexArray(0);
  gl_.UseProgram(0);
  gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace rocinante::bench
