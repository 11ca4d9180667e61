#include "viewer/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/transform.h"
#include "viewer/render/draw_list.h"
#include "viewer/render/draw_passes.h"
#include "viewer/render/inputs_hash.h"
#include "viewer/render/session_drawings.h"

namespace rocinante {
namespace {

constexpr int kTextPixels = 16;

/// How far before and behind the eye an orthographic camera must reach. A power of two, so that
/// small movements do not change anyone's depth.
double reachOf(const Vec3& eye, const std::vector<Vec3>& corners, double grid_m) {
  double farthest = grid_m;
  for (const Vec3& corner : corners) {
    const Vec3 offset = corner - eye;
    farthest = std::max(farthest,
                        std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z));
  }
  const double from_origin = std::sqrt(eye.x * eye.x + eye.y * eye.y + eye.z * eye.z);
  farthest = std::max(farthest, from_origin + grid_m * 1.5);
  double reach = 1;
  while (reach < farthest && reach < 1e12) reach *= 2;
  return reach;
}

}  // namespace

struct Renderer::Impl {
  Impl(const GlTable& table, const Cell& the_cell, Profile profile)
      : gl(table),
        key(rendererKey(gl)),
        cell(the_cell),
        catalog(cell),
        atlas(kTextPixels),
        meshes(gl, catalog, inputs),
        textures(gl, catalog.textures(), profile, inputs) {
    inputs.add(std::as_bytes(std::span(atlas.coverage())));
    inputs_text = inputs.text();
  }

  GlTable gl;
  RendererKey key;
  const Cell& cell;
  SceneCatalog catalog;
  TextAtlas atlas;
  InputsHash inputs;
  MeshBuffers meshes;
  TextureStore textures;
  std::optional<DrawPasses> passes;
  std::string inputs_text;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Result<Renderer> Renderer::create(RenderContext& context, const Cell& cell, Profile profile) {
  const Result<GlTable> gl =
      fillGlTable([&](const char* name) { return context.procAddress(name); });
  if (!gl) return gl.error();
  if (profile == Profile::reproducible) {
    if (Status fit = requireReproducible(rendererKey(*gl)); !fit) return fit.error();
  }
  auto impl = std::make_unique<Impl>(*gl, cell, profile);
  auto passes = DrawPasses::create(impl->gl, impl->atlas);
  if (!passes) return passes.error();
  impl->passes.emplace(std::move(*passes));
  return Renderer(std::move(impl));
}

Result<DrawCounts> Renderer::draw(const SceneFrame& frame, const FrameBuffer& target) {
  const Impl& my = *impl_;
  const CellScene& look = my.cell.scene;
  const ViewChoice& choice = *frame.choice;
  // App: where everything is, seen from where.
  double reach = 0;
  if (frame.camera.ortho_height_m) {
    reach = reachOf(frame.camera.eye, visibleCorners(*frame.scene, my.catalog, choice),
                    look.grid_size_m);
  }
  const Camera camera(frame.camera, target.width(), target.height(), my.passes->clipDepth(), reach);

  // Cull: what of it can be seen, in which order.
  const DrawList list =
      makeDrawList(*frame.scene, my.catalog, choice, camera, my.textures.translucent());
  Overlay in_scene(camera);
  addLinesAndPoints(in_scene, frame.scene->drawings, choice);
  Overlay on_top(camera);
  addLabels(on_top, frame.scene->drawings, choice, camera, my.atlas);
  if (choice.layerVisible("gnomon")) on_top.addGnomon(my.atlas);

  // Draw.
  const DrawPasses& passes = *my.passes;
  target.bind();
  passes.begin();
  passes.background.draw(look);
  passes.scene.drawOpaque(list, my.catalog, my.meshes, my.textures, camera, look);
  if (look.grid && choice.layerVisible("grid")) passes.grid.draw(camera, look);
  // Before what is translucent, so that a planner's line shows through a ghost.
  passes.overlay.drawInScene(in_scene);
  passes.scene.drawTranslucent(list, my.catalog, my.meshes, my.textures, camera, look);
  passes.overlay.drawOnTop(on_top);
  passes.end();
  if (const GLenum fault = my.gl.GetError(); fault != GL_NO_ERROR) {
    return Error{
        ErrorKind::refused, fmt::format("the GL driver reports error 0x{:04x}", fault), {}};
  }
  return DrawCounts{list.triangles, list.opaque.size() + list.translucent.size()};
}

CameraView Renderer::fittedCamera(const PosedScene& scene, const ViewChoice& choice, int width,
                                  int height) const {
  return fittedView(visibleCorners(scene, impl_->catalog, choice), width, height);
}

std::vector<Vec3> Renderer::visiblePoints(const PosedScene& scene, const ViewChoice& choice) const {
  return visibleCorners(scene, impl_->catalog, choice);
}

Bounds Renderer::visibleBounds(const PosedScene& scene, const ViewChoice& choice) const {
  Bounds bounds;
  for (const Vec3& corner : visibleCorners(scene, impl_->catalog, choice)) bounds.add(corner);
  return bounds;
}

const GlTable& Renderer::gl() const { return impl_->gl; }
const RendererKey& Renderer::key() const { return impl_->key; }
const TextAtlas& Renderer::text() const { return impl_->atlas; }
const std::string& Renderer::inputsHash() const { return impl_->inputs_text; }
const std::vector<std::string>& Renderer::warnings() const { return impl_->textures.warnings(); }

}  // namespace rocinante
