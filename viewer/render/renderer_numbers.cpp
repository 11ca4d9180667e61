// Frames of numbers in place of colours: whose each pixel is, and how far away.
#include "viewer/render/identity_numbers.h"
#include "viewer/render/renderer_impl.h"
#include "viewer/render/session_drawings.h"

namespace rocinante {

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
  Impl& my = *impl_;
  if (Status ready = my.prepareIdentity(target); !ready) return ready.error();
  const IdentityNumbers numbers(*frame.scene);
  const auto looks = my.looksOf(frame);
  if (!looks) return looks.error();
  const auto number_of = [&](const DrawItem& item) {
    return numbers.ofLink(item.device, item.link);
  };
  const auto drawView = [&](const CameraView& view, const PixelRectangle& part) -> Status {
    const Camera camera = my.cameraOf(frame, view, part.width, part.height);
    my.identity_pass->begin(part, target.height());
    setClamp(my.gl, camera.orthographic());
    if (Status drawn = my.drawNumbers(frame, *looks, camera, number_of); !drawn) return drawn;
    Overlay in_scene(camera, frame.scale);
    addLinesAndPoints(in_scene, frame.scene->drawings, *frame.choice);
    my.identity_pass->drawOverlay(in_scene, numbers.ofVertices(in_scene), true);
    Overlay on_top(camera, frame.scale);
    addLabels(on_top, frame.scene->drawings, *frame.choice, camera, my.atlasOf(frame.scale),
              styleOf(frame).labels);
    my.identity_pass->drawOverlay(on_top, numbers.ofVertices(on_top), false);
    return {};
  };
  Status drawn = drawView(frame.camera, {0, 0, target.width(), target.height()});
  for (const FrameInset& inset : frame.insets) {
    if (drawn) drawn = drawView(inset.camera, inset.part);
  }
  if (!drawn) return drawn.error();
  setClamp(my.gl, false);
  my.identity_pass->end();
  if (Status fine = my.glStatus(); !fine) return fine.error();
  return numbers.frame(IdentityPass::readNumbers(target), target.width(), target.height());
}

Result<DepthFrame> Renderer::depth(const SceneFrame& frame, const FrameBuffer& target) {
  Impl& my = *impl_;
  if (Status ready = my.prepareIdentity(target); !ready) return ready.error();
  const Camera camera = my.cameraOf(frame, frame.camera, target.width(), target.height());
  const auto looks = my.looksOf(frame);
  if (!looks) return looks.error();
  my.identity_pass->begin({0, 0, target.width(), target.height()}, target.height());
  setClamp(my.gl, camera.orthographic());
  Status drawn = my.drawNumbers(frame, *looks, camera, [](const DrawItem&) { return 1U; });
  if (!drawn) return drawn.error();
  DepthFrame depth{target.width(), target.height(), my.identity_pass->readDepth(target, camera)};
  setClamp(my.gl, false);
  my.identity_pass->end();
  if (Status fine = my.glStatus(); !fine) return fine.error();
  return depth;
}

}  // namespace rocinante
