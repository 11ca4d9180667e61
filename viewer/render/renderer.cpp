#include "viewer/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/transform.h"
#include "viewer/cull/coplanar_surfaces.h"
#include "viewer/gl/viewport.h"
#include "viewer/overlay/inspection_marks.h"
#include "viewer/overlay/session_drawings.h"
#include "viewer/render/inset_frame.h"
#include "viewer/render/renderer_impl.h"
#include "viewer/view/depth_reach.h"

namespace rocinante {
namespace {

/// Colour of edge lines. The opacity is a whole number of 255ths: 0.9 is 229.5 of them, where the
/// last bit of an interpolated 1.0 decides, and versions of Mesa differ in it.
constexpr glm::vec4 kEdgeColor{0.09F, 0.11F, 0.14F, 230.0F / 255};
constexpr double kScaleBarPx = 180;
/// Of a mesh that is coarsened while nothing else happens: a page would stand still for longer.
constexpr std::size_t kMostCoarsenedIndices = 300'000;
/// Limit of one view. Software GL takes about 20 s and 1 GB for this many and crashes with far
/// more.
constexpr std::uint64_t kMaxFrameTriangles = 100'000'000;

/// Number of items, from back to front, that are farther than all ghosts.
std::size_t countBehind(std::span<const DrawItem> items, std::span<const DrawItem> ghosts) {
  double farthest = ghosts.empty() ? HUGE_VAL : -HUGE_VAL;
  for (const DrawItem& ghost : ghosts) farthest = std::max(farthest, ghost.distance);
  const auto first = std::find_if(items.begin(), items.end(), [&](const DrawItem& item) {
    return !(item.distance > farthest);
  });
  return static_cast<std::size_t>(first - items.begin());
}

}  // namespace

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
  return Renderer(std::move(impl));
}

const TextAtlas& Renderer::Impl::atlasOf(double scale) const {
  const int line_px = static_cast<int>(std::floor(kTextPixels * scale + 0.5));
  if (line_px == kTextPixels) return atlas;
  return other_atlases.try_emplace(line_px, line_px).first->second;
}

Camera Renderer::Impl::cameraOf(const SceneFrame& frame, const CameraView& view, int width,
                                int height) const {
  const Camera camera(view, width, height, passes.clipDepth(), 1);
  if (!camera.orthographic()) return camera;
  const double reach = depthReach(camera, visibleCorners(*frame.scene, catalog, *frame.choice),
                                  cell.scene.grid_size_m);
  return Camera(view, width, height, passes.clipDepth(), reach);
}

Status Renderer::Impl::glStatus() const {
  const GLenum fault = gl.GetError();
  if (fault == GL_NO_ERROR) return {};
  return Error{ErrorKind::refused, fmt::format("the GL driver reports error 0x{:04x}", fault), {}};
}

Result<LinkLooks> Renderer::Impl::looksOf(const SceneFrame& frame) {
  auto made = LinkLooks::make(styleOf(frame), frame.extras, frame.scene);
  if (made && made->anyCollision() && !collision) collision.emplace(gl, cell);
  return made;
}

std::vector<DrawnSet> Renderer::Impl::setsOf(const SceneFrame& frame, const LinkLooks& looks,
                                             const Camera& camera, DrawList& list,
                                             DrawList& collisions) const {
  makeDrawList(list, *frame.scene, catalog, *frame.choice, camera, textures.translucent(), looks,
               DrawnGeometry::visuals, frame.detail);
  std::vector<DrawnSet> sets{{&list, &catalog, &meshes, &textures}};
  std::vector<LiftedList> lifted{{&list, &catalog}};
  if (looks.anyCollision()) {
    collisions = collisionListOf(frame, camera, looks);
    sets.push_back({&collisions, &collision->catalog, &collision->meshes, nullptr});
    lifted.push_back({&collisions, &collision->catalog});
  }
  liftCoplanarItems(lifted, *frame.scene, camera);
  return sets;
}

Status Renderer::Impl::checkTriangles(std::span<const DrawnSet> sets) {
  std::uint64_t triangles = 0;
  for (const DrawnSet& set : sets) triangles += set.list->triangles;
  if (triangles <= kMaxFrameTriangles) return {};
  return Error{ErrorKind::unsupported,
               fmt::format("the frame has {} triangles, more than the limit of {}: hide objects "
                           "or lower the detail (--hide, --detail)",
                           triangles, kMaxFrameTriangles),
               {}};
}

Status Renderer::Impl::drawEdges(std::span<const DrawnSet> sets, const SceneFrame& frame,
                                 const Camera& camera) {
  const RenderStyle& style = styleOf(frame);
  bool any = style.edges != EdgeStyle::none;
  for (const DrawnSet& set : sets) any = any || !set.list->wireframe.empty();
  if (!any) return {};
  const auto edges = look_passes.edges();
  if (!edges) return edges.error();
  for (const DrawnSet& set : sets) {
    if (style.edges != EdgeStyle::none) {
      const auto choice =
          style.edges == EdgeStyle::only ? EdgeChoice::features_alone : EdgeChoice::features;
      for (const auto* items : {&set.list->opaque, &set.list->translucent}) {
        (*edges)->draw(*items, *set.catalog, camera, frame.scale, choice,
                       [](const DrawItem&) { return kEdgeColor; });
      }
    }
    (*edges)->draw(set.list->wireframe, *set.catalog, camera, frame.scale, EdgeChoice::all,
                   [](const DrawItem& item) { return item.diffuse; });
  }
  return {};
}

Status Renderer::Impl::drawBackdrop(const SceneFrame& frame, const CameraView& view,
                                    std::size_t number, const Camera& camera, double opacity) {
  const bool wanted = number == 0 ? frame.main_has_backdrop : frame.insets[number - 1].has_backdrop;
  if (!wanted || frame.backdrop == nullptr || !view.intrinsics || camera.orthographic()) return {};
  const auto pass = look_passes.backdrops();
  if (!pass) return pass.error();
  (*pass)->draw(*frame.backdrop, *view.intrinsics, camera.width(), camera.height(), opacity);
  return {};
}

Overlay Renderer::Impl::onTopOf(const SceneFrame& frame, const Camera& camera,
                                const CameraView& view) const {
  const RenderStyle& style = styleOf(frame);
  const TextAtlas& glyphs = atlasOf(frame.scale);
  Overlay on_top(camera, frame.scale);
  addLabels(on_top, frame.scene->drawings, *frame.choice, camera, glyphs, style.labels);
  on_top.setOwner(0);
  addLinkFrames(on_top, *frame.scene, *frame.choice, style.frames, camera, glyphs);
  addMeasures(on_top, *frame.scene, style, glyphs);
  if (style.camera_cone && &view != &frame.camera && camera.orthographic()) {
    const Camera shown(frame.camera, whole_width, whole_height, passes.clipDepth(), 1);
    addCameraCone(on_top, shown, shown.depthOf(frame.camera.target), camera);
  }
  if (frame.extras != nullptr) {
    addClearances(on_top, frame.extras->clearances, style.lengths, glyphs);
    if (frame.extras->nearest) {
      addClearances(on_top, {*frame.extras->nearest}, style.lengths, glyphs);
    }
  }
  if (frame.choice->layerVisible("gnomon")) on_top.addGnomon(glyphs);
  if (style.scale_bar) {
    const double metres_per_pixel = camera.metersPerPixel(camera.depthOf(view.target));
    const auto bar = scaleBar(metres_per_pixel * frame.scale, kScaleBarPx);
    if (bar) on_top.addScaleBar(glyphs, *bar);
  }
  return on_top;
}

Result<DrawCounts> Renderer::Impl::drawView(const SceneFrame& frame, const LinkLooks& looks,
                                            const CameraView& view, std::size_t number,
                                            const PixelRectangle& part, int frame_height) {
  const CellScene& look = cell.scene;
  const ViewChoice& choice = *frame.choice;
  const RenderStyle& style = styleOf(frame);
  DrawCounts counts;
  StageClock clock;
  // App: poses and camera.
  const Camera camera = cameraOf(frame, view, part.width, part.height);

  clock.endStage(counts.times.app);
  // Cull: visible items in drawing order.
  DrawList collisions;
  const std::vector<DrawnSet> sets = setsOf(frame, looks, camera, view_list, collisions);
  if (Status fits = checkTriangles(sets); !fits) return fits.error();
  const DrawList& list = view_list;
  Overlay in_scene(camera, frame.scale);
  addLinesAndPoints(in_scene, frame.scene->drawings, choice);
  if (frame.extras != nullptr) addTrails(in_scene, frame.extras->trails);

  clock.endStage(counts.times.cull);
  // Draw. First the light and other inputs of this view.
  const glm::vec2 origin(part.x, frame_height - part.y - part.height);
  const auto light = drawLight(frame, looks, camera, number, sets, origin);
  if (!light) return light.error();
  OutlinePass* outlines = nullptr;
  if (looks.anyOutlined()) {
    const auto made = look_passes.outlines();
    if (!made) return made.error();
    outlines = *made;
    if (Status found = outlines->find(sets, camera, frame.scale); !found) return found.error();
  }
  SurfaceLook surfaces;
  surfaces.shading = style.shading;
  surfaces.shadows = light->shadows ? &*light->shadows : nullptr;
  surfaces.contact = light->contact ? &*light->contact : nullptr;
  surfaces.depth_ranks = style.edges != EdgeStyle::none
                             ? EdgePass::kSurfaceRanks * static_cast<float>(frame.scale)
                             : 0;
  surfaces.depth_only = style.edges == EdgeStyle::only;
  surfaces.holes = std::ranges::any_of(textures.translucent(), [](auto each) { return each != 0; });
  surfaces.cutouts = catalog.hasCutouts();
  if (Status ready = passes.prepare(surfaces, look); !ready) return ready.error();

  const bool plain_filtering = frame.detail.plain_filtering || style.shading == Shading::plain;
  passes.begin(look, part, frame_height, frame.only);
  if (Status behind = drawBackdrop(frame, view, number, camera, 1); !behind) return behind.error();
  setClamp(gl, camera.orthographic());
  if (plain_filtering) textures.beginPlainFiltering();
  for (const DrawnSet& set : sets) {
    passes.scene.drawOpaque(*set.list, *set.catalog, *set.meshes, textures, camera, look, surfaces);
  }
  textures.endPlainFiltering();
  if (Status lines = drawEdges(sets, frame, camera); !lines) return lines.error();
  if (look.grid && choice.layerVisible("grid")) {
    const Status grid =
        passes.grid.draw(camera, look, frame.scale, surfaces.shadows, surfaces.contact);
    if (!grid) return grid.error();
  }
  // Before translucent items, so that a planner's line shows through a ghost.
  passes.overlay.drawInScene(in_scene);
  const auto drawTranslucent = [&](bool behind_ghosts) {
    if (surfaces.depth_only) return;
    if (plain_filtering) textures.beginPlainFiltering();
    for (const DrawnSet& set : sets) {
      const std::span<const DrawItem> items = set.list->translucent;
      const std::size_t behind = countBehind(items, list.ghosts);
      passes.scene.drawTranslucent(behind_ghosts ? items.first(behind) : items.subspan(behind),
                                   *set.catalog, *set.meshes, textures, camera, look, surfaces);
    }
    textures.endPlainFiltering();
  };
  if (!list.ghosts.empty()) {
    const auto ghosts = look_passes.ghosts();
    if (!ghosts) return ghosts.error();
    drawTranslucent(true);
    (*ghosts)->draw(list.ghosts, catalog, meshes, camera);
  }
  drawTranslucent(false);
  setClamp(gl, false);
  const Status over = drawBackdrop(frame, view, number, camera, frame.backdrop_opacity);
  if (!over) return over.error();
  if (outlines != nullptr) outlines->draw();
  if (frame.on_top) passes.overlay.drawOnTop(onTopOf(frame, camera, view));
  for (const DrawnSet& set : sets) {
    counts.triangles += set.list->triangles;
    counts.draws += set.list->opaque.size() + set.list->translucent.size() +
                    set.list->wireframe.size() + set.list->ghosts.size();
  }
  clock.endStage(counts.times.draw);
  return counts;
}

void Renderer::Impl::drawInsetFrames(const SceneFrame& frame, const FrameBuffer& target) const {
  const Camera whole(frame.camera, target.width(), target.height(), passes.clipDepth(), 1);
  for (const FrameInset& inset : frame.insets) {
    // In pixels of the whole picture, clipped to the inset.
    setViewport(gl, inset.part, target.height(), frame.only);
    gl.Viewport(0, 0, target.width(), target.height());
    Overlay overlay(whole, frame.scale);
    addInsetFrame(overlay, inset, atlasOf(frame.scale));
    passes.overlay.drawOnTop(overlay);
  }
}

Result<DrawCounts> Renderer::draw(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& impl = *impl_;
  const auto looks = impl.looksOf(frame);
  if (!looks) return looks.error();
  impl.passes.overlay.useText(impl.atlasOf(frame.scale));
  impl.whole_width = target.width();
  impl.whole_height = target.height();
  target.bind();
  const PixelRectangle whole{0, 0, target.width(), target.height()};
  ++impl.frames_drawn;
  if (!frame.goes_on) impl.lights.clear();
  auto counts = impl.drawView(frame, *looks, frame.camera, 0, whole, target.height());
  if (!counts) return counts.error();
  for (std::size_t i = 0; i < frame.insets.size(); ++i) {
    const FrameInset& inset = frame.insets[i];
    if (frame.only && overlapOf(inset.part, *frame.only).height == 0) continue;
    const auto more =
        impl.drawView(frame, *looks, inset.camera, i + 1, inset.part, target.height());
    if (!more) return more.error();
    counts->triangles += more->triangles;
    counts->draws += more->draws;
    counts->times += more->times;
  }
  if (frame.on_top) impl.drawInsetFrames(frame, target);
  impl.passes.end();
  if (Status fine = impl.glStatus(); !fine) return fine.error();
  return counts;
}

Status Renderer::drawOnTop(const SceneFrame& frame, const FrameBuffer& target,
                           const std::function<void(std::size_t)>& refill_inset) {
  Impl& impl = *impl_;
  if (Status ready = impl.passes.overlay.prepare(); !ready) return ready;
  impl.passes.overlay.useText(impl.atlasOf(frame.scale));
  impl.whole_width = target.width();
  impl.whole_height = target.height();
  target.resolve();
  const auto drawView = [&](const CameraView& view, const PixelRectangle& part) {
    impl.passes.beginOnTop(part, target.height());
    const Camera camera = impl.cameraOf(frame, view, part.width, part.height);
    impl.passes.overlay.drawOnTop(impl.onTopOf(frame, camera, view));
  };
  drawView(frame.camera, {0, 0, target.width(), target.height()});
  for (std::size_t i = 0; i < frame.insets.size(); ++i) {
    if (refill_inset) refill_inset(i);
    drawView(frame.insets[i].camera, frame.insets[i].part);
  }
  impl.drawInsetFrames(frame, target);
  impl.passes.end();
  return impl.glStatus();
}

void Renderer::prepareDetail(const DetailCache& cache, int threads) {
  if (impl_->detail_builder) return;
  impl_->detail_builder.emplace(impl_->catalog.detailInputs(), cache, threads);
}

bool Renderer::takeReadyDetail(bool wait_for_all) {
  Impl& impl = *impl_;
  if (!impl.detail_builder || impl.detail_builder->finished()) return false;
  const std::vector<ReadyDetail> ready =
      wait_for_all ? impl.detail_builder->waitForAll() : impl.detail_builder->takeReady();
  for (const ReadyDetail& one : ready) {
    impl.meshes.setDetail(one.number, impl.catalog.meshes()[one.number].indices(),
                          one.detail.indices);
    impl.catalog.setDetail(one.number, one.detail);
  }
  return !ready.empty();
}

bool Renderer::makeNextDetail() {
  Impl& impl = *impl_;
  if (!impl.detail_left) {
    impl.detail_left = impl.catalog.detailInputs();
    for (std::size_t i = 0; i < impl.detail_left->size(); ++i) impl.detail_order.push_back(i);
    std::ranges::stable_sort(impl.detail_order, {}, [&](std::size_t number) {
      return (*impl.detail_left)[number].indices->size();
    });
  }
  if (impl.detail_order.empty()) return false;
  const std::size_t number = impl.detail_order.back();
  impl.detail_order.pop_back();
  if ((*impl.detail_left)[number].indices->size() > kMostCoarsenedIndices) {
    return !impl.detail_order.empty();
  }
  const MeshDetail detail = makeMeshDetail((*impl.detail_left)[number]);
  impl.meshes.setDetail(number, impl.catalog.meshes()[number].indices(), detail.indices);
  impl.catalog.setDetail(number, detail);
  return !impl.detail_order.empty();
}

bool Renderer::detailReady() const {
  return impl_->detail_builder && impl_->detail_builder->finished();
}

CameraView Renderer::fittedCamera(const PosedScene& scene, const ViewChoice& choice, int width,
                                  int height) const {
  return fittedView(visibleCorners(scene, impl_->catalog, choice), width, height);
}

std::vector<Vec3> Renderer::visiblePoints(const PosedScene& scene, const ViewChoice& choice,
                                          const DeviceNames* devices) const {
  return visibleCorners(scene, impl_->catalog, choice, devices);
}

Bounds Renderer::visibleBounds(const PosedScene& scene, const ViewChoice& choice,
                               const DeviceNames* devices) const {
  Bounds bounds;
  for (const Vec3& corner : visiblePoints(scene, choice, devices)) bounds.add(corner);
  return bounds;
}

std::uint64_t Renderer::framesDrawn() const { return impl_->frames_drawn; }
const GlTable& Renderer::gl() const { return impl_->gl; }
const RendererKey& Renderer::key() const { return impl_->key; }
const TextAtlas& Renderer::text(double scale) const { return impl_->atlasOf(scale); }
const std::string& Renderer::inputsHash() const { return impl_->inputs_text; }
void Renderer::finishPictures() { impl_->textures.finish(); }
bool Renderer::readNextPicture() { return impl_->textures.readNext(); }
const std::vector<std::string>& Renderer::warnings() const { return impl_->textures.warnings(); }

}  // namespace rocinante
