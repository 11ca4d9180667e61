#include "viewer/render/frame_maker.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/duration_text.h"
#include "core/model/posed_scene.h"
#include "viewer/render/camera_choice.h"
#include "viewer/render/renderer.h"

namespace rocinante {
namespace {

/// A fitted view must hold what moves in the session, and be the same at all its times: it is
/// fitted to so many moments, spread evenly from the first to the last.
constexpr int kFitMoments = 9;

Result<std::unique_ptr<RenderContext>> makeContext(Profile profile) {
  if (profile == Profile::fast) {
    if (auto context = makeEglContext()) return context;
  }
  return makeOsmesaContext();
}

}  // namespace

struct FrameMaker::Impl {
  explicit Impl(Cell the_cell) : cell(std::move(the_cell)) {}
  ~Impl() {
    // Deleting GL objects needs their context.
    if (context && !context->makeCurrent()) return;
  }

  Result<const SessionState*> stateAt(LogTime time) {
    if (!session) return &nothing_said;
    return session->stateAt(time);
  }
  Result<CameraView> cameraFor(const FrameRequest& request, const PosedScene& scene,
                               const ViewChoice& choice);
  Status findScenesToFit();

  Cell cell;
  std::optional<Timeline> session;
  SessionState nothing_said;
  std::vector<PosedScene> scenes_to_fit;  // without drawings: they outlive their states
  std::unique_ptr<RenderContext> context;
  std::optional<Renderer> renderer;
  std::optional<FrameBuffer> target;
};

Status FrameMaker::Impl::findScenesToFit() {
  if (!scenes_to_fit.empty()) return {};
  const int moments = session ? kFitMoments : 1;
  for (int i = 0; i < moments; ++i) {
    LogTime moment{};
    if (session)
      moment = session->start() + (session->end() - session->start()) / (moments - 1) * i;
    const auto state = stateAt(moment);
    if (!state) return state.error();
    scenes_to_fit.push_back(poseScene(cell, **state));
    scenes_to_fit.back().drawings.clear();
  }
  return {};
}

Result<CameraView> FrameMaker::Impl::cameraFor(const FrameRequest& request, const PosedScene& scene,
                                               const ViewChoice& choice) {
  if (!request.camera.empty()) return chooseCamera(request.camera, scene);
  // The cell's own come first in the scene's.
  if (!cell.cameras.empty()) return viewOf(scene.cameras.front());
  std::vector<Vec3> points;
  for (const PosedScene& fitted : scenes_to_fit) {
    const std::vector<Vec3> some = renderer->visiblePoints(fitted, choice);
    points.insert(points.end(), some.begin(), some.end());
  }
  return fittedView(points, request.width, request.height);
}

FrameMaker::FrameMaker(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FrameMaker::~FrameMaker() = default;
FrameMaker::FrameMaker(FrameMaker&&) noexcept = default;
FrameMaker& FrameMaker::operator=(FrameMaker&&) noexcept = default;

Result<FrameMaker> FrameMaker::open(Cell cell, std::optional<Timeline> session, Profile profile) {
  auto impl = std::make_unique<Impl>(std::move(cell));
  impl->session = std::move(session);
  auto context = makeContext(profile);
  if (!context) return context.error();
  impl->context = std::move(*context);
  auto renderer = Renderer::create(*impl->context, impl->cell, profile);
  if (!renderer) return renderer.error();
  impl->renderer = std::move(*renderer);
  // Everything is in memory now: a folder made for this cell alone can go.
  impl->cell.keeps_files.reset();
  return FrameMaker(std::move(impl));
}

Result<Picture> FrameMaker::frame(const FrameRequest& request) {
  Impl& my = *impl_;
  if (my.session && (request.time < my.session->start() || request.time > my.session->end())) {
    const auto shown = [&](LogTime time) { return secondsText(time - my.session->origin(), 3); };
    return Error{ErrorKind::bad_argument,
                 fmt::format("{} s is outside the log, which has {} to {} s", shown(request.time),
                             shown(my.session->start()), shown(my.session->end())),
                 my.session->log().name()};
  }
  if (Status current = my.context->makeCurrent(); !current) return current.error();
  const auto choice = ViewChoice::make(request.hide, request.show);
  if (!choice) return choice.error();
  // Before the state at the time asked for, which is valid until the next question only.
  if (request.camera.empty() && my.cell.cameras.empty()) {
    if (Status found = my.findScenesToFit(); !found) return found.error();
  }
  const auto state = my.stateAt(request.time);
  if (!state) return state.error();
  const PosedScene scene = poseScene(my.cell, **state);
  const auto camera = my.cameraFor(request, scene, *choice);
  if (!camera) return camera.error();

  if (!my.target || my.target->width() != request.width || my.target->height() != request.height ||
      my.target->samples() != request.samples) {
    auto target =
        FrameBuffer::create(my.renderer->gl(), request.width, request.height, request.samples);
    if (!target) return target.error();
    my.target = std::move(*target);
  }
  const auto drawn = my.renderer->draw({&scene, *camera, &*choice, &request.style}, *my.target);
  if (!drawn) return drawn.error();
  my.target->resolve();
  return my.target->read();
}

const RendererKey& FrameMaker::key() const { return impl_->renderer->key(); }
const std::string& FrameMaker::inputsHash() const { return impl_->renderer->inputsHash(); }
const std::vector<std::string>& FrameMaker::warnings() const { return impl_->renderer->warnings(); }
const Cell& FrameMaker::cell() const { return impl_->cell; }
Timeline* FrameMaker::session() { return impl_->session ? &*impl_->session : nullptr; }

}  // namespace rocinante
