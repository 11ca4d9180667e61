// Frames of numbers instead of colours: identity and depth.
#include <algorithm>
#include <cmath>

#include "viewer/overlay/session_drawings.h"
#include "viewer/render/identity_frame.h"
#include "viewer/render/renderer_impl.h"

namespace rocinante {
namespace {

/// A click selects objects up to this many pixels away.
constexpr int kPickReach = 2;

/// The world point at a depth behind the centre of a pixel.
Vec3 pointAt(const Camera& camera, int x, int y, double depth_m) {
  const double metres = camera.metersPerPixel(depth_m);
  const Vec2& center = camera.center();
  const double right =
      (x + 0.5 - camera.width() * 0.5 * (1 + center.x)) * metres * camera.pixelAspect();
  const double up = (camera.height() * 0.5 * (1 - center.y) - (y + 0.5)) * metres;
  return camera.eye() + camera.forward() * depth_m + camera.right() * right + camera.up() * up;
}

}  // namespace

Status Renderer::Impl::prepareIdentity(const FrameBuffer& target) {
  if (!identity_pass) {
    auto made = IdentityPass::create(gl);
    if (!made) return made.error();
    identity_pass.emplace(std::move(*made));
  }
  target.bind();
  return {};
}

Status Renderer::Impl::drawNumbers(const SceneFrame& frame, const LinkLooks& looks,
                                   const Camera& camera,
                                   const std::function<std::uint32_t(const DrawItem&)>& number_of) {
  DrawList list, collisions;
  const std::vector<DrawnSet> sets = setsOf(frame, looks, camera, list, collisions);
  if (Status fits = checkTriangles(sets); !fits) return fits;
  for (const DrawnSet& set : sets) identity_pass->drawSurfaces(set, textures, camera, number_of);
  for (const DrawnSet& set : sets) {
    if (set.list->wireframe.empty()) continue;
    const auto edges = look_passes.edges();
    if (!edges) return edges.error();
    (*edges)->draw(set.list->wireframe, *set.catalog, camera, frame.scale, EdgeChoice::all,
                   [&](const DrawItem& item) { return IdentityPass::colorOf(number_of(item)); });
  }
  return {};
}

Result<IdentityFrame> Renderer::identity(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& impl = *impl_;
  if (Status ready = impl.prepareIdentity(target); !ready) return ready.error();
  const IdentityNumbers numbers(*frame.scene);
  const auto looks = impl.looksOf(frame);
  if (!looks) return looks.error();
  const auto number_of = [&](const DrawItem& item) {
    return numbers.ofLink(item.device, item.link);
  };
  const auto drawView = [&](const CameraView& view, const PixelRectangle& part) -> Status {
    const Camera camera = impl.cameraOf(frame, view, part.width, part.height);
    impl.identity_pass->begin(part, target.height());
    setClamp(impl.gl, camera.orthographic());
    if (Status drawn = impl.drawNumbers(frame, *looks, camera, number_of); !drawn) return drawn;
    Overlay in_scene(camera, frame.scale);
    addLinesAndPoints(in_scene, frame.scene->drawings, *frame.choice);
    impl.identity_pass->drawOverlay(in_scene, numbers.ofVertices(in_scene), true);
    Overlay on_top(camera, frame.scale);
    addLabels(on_top, frame.scene->drawings, *frame.choice, camera, impl.atlasOf(frame.scale),
              styleOf(frame).labels);
    impl.identity_pass->drawOverlay(on_top, numbers.ofVertices(on_top), false);
    return {};
  };
  Status drawn = drawView(frame.camera, {0, 0, target.width(), target.height()});
  for (const FrameInset& inset : frame.insets) {
    if (drawn) drawn = drawView(inset.camera, inset.part);
  }
  if (!drawn) return drawn.error();
  setClamp(impl.gl, false);
  impl.identity_pass->end();
  if (Status fine = impl.glStatus(); !fine) return fine.error();
  return numbers.frame(IdentityPass::readNumbers(target), target.width(), target.height());
}

Result<std::optional<PickedLink>> Renderer::pick(const SceneFrame& frame, int width, int height,
                                                 double x, double y) {
  Impl& impl = *impl_;
  CameraView view = frame.camera;
  PixelRectangle part{0, 0, width, height};
  for (const FrameInset& inset : frame.insets) {
    const PixelRectangle& at = inset.part;
    if (!(x >= at.x && y >= at.y && x < at.x + at.width && y < at.y + at.height)) continue;
    part = at;
    view = inset.camera;
  }
  const int clicked_x = static_cast<int>(std::floor(x));
  const int clicked_y = static_cast<int>(std::floor(y));
  const int left = std::max(clicked_x - kPickReach, part.x);
  const int top = std::max(clicked_y - kPickReach, part.y);
  const int right = std::min(clicked_x + kPickReach + 1, part.x + part.width);
  const int bottom = std::min(clicked_y + kPickReach + 1, part.y + part.height);
  if (left >= right || top >= bottom) return std::optional<PickedLink>();

  if (!impl.pick_target || impl.pick_target->width() != width ||
      impl.pick_target->height() != height) {
    auto made = FrameBuffer::create(impl.gl, width, height, 1);
    if (!made) return made.error();
    impl.pick_target = std::move(*made);
  }
  if (Status ready = impl.prepareIdentity(*impl.pick_target); !ready) return ready.error();
  const Camera camera = impl.cameraOf(frame, view, part.width, part.height);
  const auto looks = impl.looksOf(frame);
  if (!looks) return looks.error();
  const IdentityNumbers numbers(*frame.scene);
  // Drawn as in identity(), but only near the pixel.
  impl.identity_pass->begin(part, height);
  impl.gl.Scissor(left, height - bottom, right - left, bottom - top);
  setClamp(impl.gl, camera.orthographic());
  Status drawn = impl.drawNumbers(frame, *looks, camera, [&](const DrawItem& item) {
    return numbers.ofLink(item.device, item.link);
  });
  if (!drawn) return drawn.error();
  std::optional<PickedLink> nearest;
  int best = 2 * (kPickReach + 1) * (kPickReach + 1);
  const PixelRectangle asked{left, top, right - left, bottom - top};
  for (const NumberedPixel& pixel : impl.identity_pass->readPart(asked, height, camera)) {
    const int dx = pixel.x - clicked_x, dy = pixel.y - clicked_y;
    if (pixel.number == 0 || dx * dx + dy * dy >= best) continue;
    best = dx * dx + dy * dy;
    nearest = PickedLink{numbers.nameOf(pixel.number),
                         pointAt(camera, pixel.x - part.x, pixel.y - part.y, pixel.depth_m)};
  }
  setClamp(impl.gl, false);
  impl.identity_pass->end();
  if (Status fine = impl.glStatus(); !fine) return fine.error();
  return nearest;
}

Result<DepthFrame> Renderer::depth(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& impl = *impl_;
  if (Status ready = impl.prepareIdentity(target); !ready) return ready.error();
  const Camera camera = impl.cameraOf(frame, frame.camera, target.width(), target.height());
  const auto looks = impl.looksOf(frame);
  if (!looks) return looks.error();
  impl.identity_pass->begin({0, 0, target.width(), target.height()}, target.height());
  setClamp(impl.gl, camera.orthographic());
  Status drawn = impl.drawNumbers(frame, *looks, camera, [](const DrawItem&) { return 1U; });
  if (!drawn) return drawn.error();
  DepthFrame depth{target.width(), target.height(), impl.identity_pass->readDepth(target, camera)};
  setClamp(impl.gl, false);
  impl.identity_pass->end();
  if (Status fine = impl.glStatus(); !fine) return fine.error();
  return depth;
}

}  // namespace rocinante
