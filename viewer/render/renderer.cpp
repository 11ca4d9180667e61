#include "viewer/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/transform.h"
#include "viewer/render/draw_list.h"
#include "viewer/render/draw_passes.h"
#include "viewer/render/identity_numbers.h"
#include "viewer/render/identity_pass.h"
#include "viewer/render/inputs_hash.h"
#include "viewer/render/inset_frame.h"
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
  std::optional<DetailBuilder> detail_builder;  // borrows the catalog
  std::optional<IdentityPass> identity_pass;  // made when it is first asked for
  std::string inputs_text;

  Camera cameraOf(const SceneFrame& frame, const CameraView& view, int width, int height) const;
  DrawList listOf(const SceneFrame& frame, const Camera& camera) const {
    return makeDrawList(*frame.scene, catalog, *frame.choice, camera, textures.translucent(),
                        LinkLooks(), DrawnGeometry::visuals, frame.detail);
  }
  /// One view into a part of what is bound.
  DrawCounts drawView(const SceneFrame& frame, const CameraView& view, const PixelRectangle& part,
                      int frame_height) const;
  void drawInsetFrames(const SceneFrame& frame, const FrameBuffer& target) const;
  Status prepareIdentity(const FrameBuffer& target);
  Status glStatus() const;
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

Camera Renderer::Impl::cameraOf(const SceneFrame& frame, const CameraView& view, int width,
                                int height) const {
  double reach = 0;
  if (view.ortho_height_m) {
    reach = reachOf(view.eye, visibleCorners(*frame.scene, catalog, *frame.choice),
                    cell.scene.grid_size_m);
  }
  return Camera(view, width, height, passes->clipDepth(), reach);
}

Status Renderer::Impl::glStatus() const {
  const GLenum fault = gl.GetError();
  if (fault == GL_NO_ERROR) return {};
  return Error{ErrorKind::refused, fmt::format("the GL driver reports error 0x{:04x}", fault), {}};
}

DrawCounts Renderer::Impl::drawView(const SceneFrame& frame, const CameraView& view,
                                    const PixelRectangle& part, int frame_height) const {
  const CellScene& look = cell.scene;
  const ViewChoice& choice = *frame.choice;
  // App: where everything is, seen from where.
  const Camera camera = cameraOf(frame, view, part.width, part.height);

  // Cull: what of it can be seen, in which order.
  const DrawList list = listOf(frame, camera);
  Overlay in_scene(camera);
  addLinesAndPoints(in_scene, frame.scene->drawings, choice);
  Overlay on_top(camera);
  addLabels(on_top, frame.scene->drawings, choice, camera, atlas);
  if (choice.layerVisible("gnomon")) on_top.addGnomon(atlas);

  // Draw.
  passes->begin(part, frame_height);
  passes->background.draw(look);
  if (frame.detail.plain_filtering) textures.beginPlainFiltering();
  passes->scene.drawOpaque(list, catalog, meshes, textures, camera, look);
  textures.endPlainFiltering();
  if (look.grid && choice.layerVisible("grid")) passes->grid.draw(camera, look);
  // Before what is translucent, so that a planner's line shows through a ghost.
  passes->overlay.drawInScene(in_scene);
  if (frame.detail.plain_filtering) textures.beginPlainFiltering();
  passes->scene.drawTranslucent(list, catalog, meshes, textures, camera, look);
  textures.endPlainFiltering();
  passes->overlay.drawOnTop(on_top);
  return DrawCounts{list.triangles, list.opaque.size() + list.translucent.size()};
}

void Renderer::Impl::drawInsetFrames(const SceneFrame& frame, const FrameBuffer& target) const {
  const Camera whole(frame.camera, target.width(), target.height(), passes->clipDepth(), 1);
  for (const FrameInset& inset : frame.insets) {
    // Seen in pixels of the whole picture, cut off at the inset's edges.
    setViewport(gl, inset.part, target.height());
    gl.Viewport(0, 0, target.width(), target.height());
    Overlay overlay(whole);
    addInsetFrame(overlay, inset, atlas);
    passes->overlay.drawOnTop(overlay);
  }
}

Result<DrawCounts> Renderer::draw(const SceneFrame& frame, const FrameBuffer& target) {
  const Impl& my = *impl_;
  target.bind();
  const PixelRectangle whole{0, 0, target.width(), target.height()};
  DrawCounts counts = my.drawView(frame, frame.camera, whole, target.height());
  for (const FrameInset& inset : frame.insets) {
    const DrawCounts more = my.drawView(frame, inset.camera, inset.part, target.height());
    counts.triangles += more.triangles;
    counts.draws += more.draws;
  }
  my.drawInsetFrames(frame, target);
  my.passes->end();
  if (Status fine = my.glStatus(); !fine) return fine.error();
  return counts;
}

void Renderer::prepareDetail(const DetailCache& cache, int threads) {
  if (impl_->detail_builder) return;
  impl_->detail_builder.emplace(impl_->catalog.detailInputs(), cache, threads);
}

bool Renderer::takeReadyDetail(bool wait_for_all) {
  Impl& my = *impl_;
  if (!my.detail_builder || my.detail_builder->finished()) return false;
  const std::vector<ReadyDetail> ready =
      wait_for_all ? my.detail_builder->waitForAll() : my.detail_builder->takeReady();
  for (const ReadyDetail& one : ready) {
    my.meshes.setDetail(one.number, my.catalog.meshes()[one.number].indices(),
                        one.detail.indices);
    my.catalog.setDetail(one.number, one.detail);
  }
  return !ready.empty();
}

bool Renderer::detailReady() const {
  return impl_->detail_builder && impl_->detail_builder->finished();
}

Status Renderer::Impl::prepareIdentity(const FrameBuffer& target) {
  if (!identity_pass) {
    auto made = IdentityPass::create(gl);
    if (!made) return made.error();
    identity_pass.emplace(std::move(*made));
  }
  target.bind();
  return {};
}

Result<IdentityFrame> Renderer::identity(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& my = *impl_;
  if (Status ready = my.prepareIdentity(target); !ready) return ready.error();
  const IdentityNumbers numbers(*frame.scene);
  const auto drawView = [&](const CameraView& view, const PixelRectangle& part) {
    const Camera camera = my.cameraOf(frame, view, part.width, part.height);
    my.identity_pass->begin(part, target.height());
    my.identity_pass->drawGeometry(
        my.listOf(frame, camera), my.catalog, my.meshes, my.textures, camera,
        [&](const DrawItem& item) { return numbers.ofLink(item.device, item.link); });
    Overlay in_scene(camera);
    addLinesAndPoints(in_scene, frame.scene->drawings, *frame.choice);
    my.identity_pass->drawOverlay(in_scene, numbers.ofVertices(in_scene), true);
    Overlay on_top(camera);
    addLabels(on_top, frame.scene->drawings, *frame.choice, camera, my.atlas);
    my.identity_pass->drawOverlay(on_top, numbers.ofVertices(on_top), false);
  };
  drawView(frame.camera, {0, 0, target.width(), target.height()});
  for (const FrameInset& inset : frame.insets) drawView(inset.camera, inset.part);
  my.identity_pass->end();
  if (Status fine = my.glStatus(); !fine) return fine.error();
  return numbers.frame(IdentityPass::readNumbers(target), target.width(), target.height());
}

Result<DepthFrame> Renderer::depth(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& my = *impl_;
  if (Status ready = my.prepareIdentity(target); !ready) return ready.error();
  const Camera camera = my.cameraOf(frame, frame.camera, target.width(), target.height());
  my.identity_pass->begin({0, 0, target.width(), target.height()}, target.height());
  my.identity_pass->drawGeometry(my.listOf(frame, camera), my.catalog, my.meshes, my.textures,
                                 camera, [](const DrawItem&) { return 1U; });
  DepthFrame depth{target.width(), target.height(), my.identity_pass->readDepth(target, camera)};
  my.identity_pass->end();
  if (Status fine = my.glStatus(); !fine) return fine.error();
  return depth;
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
