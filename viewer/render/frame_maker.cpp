#include "viewer/render/frame_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/base/duration_text.h"
#include "core/cell/posed_scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/overlay/overlay_panel.h"
#include "viewer/render/fitted_cameras.h"
#include "viewer/render/inset_frame.h"
#include "viewer/render/renderer.h"
#include "viewer/render/scaled_view.h"
#include "viewer/render/source_rates.h"
#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"
#include "viewer/view/known_names.h"
#include "viewer/view/scene_poser.h"

namespace rocinante {
namespace {

/// A request with all its names resolved.
struct PreparedFrame {
  ViewChoice choice;
  const SessionState* state = nullptr;  // valid until the next query of the session
  PosedScene scene;                     // borrows from it
  CameraView camera;
  std::vector<FrameInset> insets;
  std::vector<std::string> inset_cameras;  // by name, as `insets`
  std::shared_ptr<const BackdropPicture> backdrop;
  double backdrop_opacity = 0;
  bool main_has_backdrop = false;
  PictureTerms terms;
  FrameExtras extras;
  std::map<std::string, std::uint64_t> counted;  // datagrams in the last second, for the panel
  const DetailRung* rung = nullptr;

  SceneFrame shown() const {
    SceneFrame frame{&scene, camera, &choice, &terms.style, &extras};
    frame.insets = insets;
    frame.detail = rung->level;
    frame.scale = terms.scale;
    frame.backdrop = backdrop.get();
    frame.backdrop_opacity = backdrop_opacity;
    frame.main_has_backdrop = main_has_backdrop;
    return frame;
  }
};

}  // namespace

struct FrameMaker::Impl {
  Impl(Cell the_cell, Profile the_profile)
      : cell(std::move(the_cell)), poser(cell), profile(the_profile) {}
  ~Impl() {
    // Deleting GL objects requires their context.
    if (context && !context->makeCurrent()) return;
  }

  Status checkTime(LogTime time) const;
  Result<const SessionState*> stateAt(LogTime time, StateDamage& damage) {
    if (!session) return given != nullptr ? given : &empty_state;
    return session->stateAt(time, &damage);
  }
  Result<CameraView> cameraNamed(const std::string& name, const FrameRequest& request,
                                 const PreparedFrame& found, int width, int height);
  bool asksFit(const FrameRequest& request) const;
  Status placeCameras(const FrameRequest& request, PreparedFrame& found);
  Status placeBackdrop(LogTime time, const std::string& main_camera, PreparedFrame& found);
  Result<PreparedFrame> find(const FrameRequest& request, StateDamage* damage);
  Result<PreparedFrame> findDamaged(const FrameRequest& request, StateDamage& damage);
  void addPanel(LogTime time, const PreparedFrame& found, Picture& picture);
  Status findRates(LogTime time, StateDamage& damage, PreparedFrame& found);
  Result<const DetailRung*> prepareRung(int detail);
  /// Draws all but the panel into `view`.
  Status draw(const FrameRequest& request, const PreparedFrame& found);
  Status prepareNumbers(const FrameRequest& request);

  Cell cell;
  ScenePoser poser;
  KnownNames names{cell};
  Profile profile;
  std::optional<Timeline> session;
  std::optional<BesideSession> beside;
  std::string backdrop_camera;
  double backdrop_opacity = 0;
  BackdropAt backdrops;  // may be empty
  SessionState empty_state;
  const SessionState* given = nullptr;  // by showState()
  SessionState by_hand;                 // with the joints of the last request
  std::unique_ptr<RenderContext> context;
  std::optional<Renderer> renderer;
  std::optional<FittedCameras> fitted;
  Impl* fit_of = this;               // whose `fitted` is used
  std::optional<SourceRates> rates;  // made on first use
  ScaledView view;
  std::optional<FrameBuffer> number_target;  // one sample per pixel
};

Status FrameMaker::Impl::checkTime(LogTime time) const {
  if (!session || (time >= session->start() && time <= session->end())) return {};
  const auto shown = [&](LogTime moment) { return secondsText(moment - session->origin(), 3); };
  return Error{ErrorKind::bad_argument,
               fmt::format("{} s is outside the log, which has {} to {} s", shown(time),
                           shown(session->start()), shown(session->end())),
               session->log().name()};
}

Result<CameraView> FrameMaker::Impl::cameraNamed(const std::string& name,
                                                 const FrameRequest& request,
                                                 const PreparedFrame& found, int width,
                                                 int height) {
  if (name.empty() && !cell.cameras.empty()) {
    // The cell's cameras come first in the scene.
    return viewOf(found.scene.cameras.front());
  }
  const std::string wanted = name.empty() ? "fit" : name;
  const bool built_in =
      FittedCameras::knows(wanted) && (name.empty() || found.scene.findCamera(wanted) == nullptr);
  if (!built_in) return chooseCamera(wanted, found.scene);
  if (const std::string_view device = FittedCameras::deviceOf(wanted); !device.empty()) {
    if (Status known = names.checkDevice(std::string(device)); !known) return known.error();
  }
  return fit_of->fitted->view(wanted, found.choice, request.hide, request.show, width, height);
}

bool FrameMaker::Impl::asksFit(const FrameRequest& request) const {
  const std::vector<CellInset>& insets = request.insets ? *request.insets : cell.insets;
  return FittedCameras::knows(request.camera) || (request.camera.empty() && cell.cameras.empty()) ||
         std::ranges::any_of(
             insets, [](const CellInset& inset) { return FittedCameras::knows(inset.camera); });
}

Status FrameMaker::Impl::placeCameras(const FrameRequest& request, PreparedFrame& found) {
  auto camera = cameraNamed(request.camera, request, found, request.width, request.height);
  if (!camera) return camera.error();
  found.camera = *camera;
  std::string main_name = request.camera;
  if (main_name.empty()) main_name = cell.cameras.empty() ? "fit" : cell.cameras.front().name;
  std::vector<CellInset> insets = request.insets ? *request.insets : cell.insets;
  std::erase_if(insets, [&](const CellInset& inset) {
    return repeatsMainView(inset, main_name, found.camera, found.scene);
  });
  const std::vector<PixelRectangle> parts =
      placeInsets(insets, request.width, request.height, request.scale);
  for (std::size_t i = 0; i < insets.size(); ++i) {
    const CellInset& inset = insets[i];
    camera = cameraNamed(inset.camera, request, found, parts[i].width, parts[i].height);
    if (!camera && request.insets) return camera.error();
    if (!camera || parts[i].width == 0) continue;
    found.insets.push_back(frameInset(inset, parts[i], *camera, backdrop_camera));
    found.inset_cameras.push_back(inset.camera);
  }
  return backdrops ? placeBackdrop(request.time, main_name, found) : Status{};
}

Status FrameMaker::Impl::placeBackdrop(LogTime time, const std::string& main_camera,
                                       PreparedFrame& found) {
  found.main_has_backdrop = hasBackdrop(main_camera, backdrop_camera);
  if (!found.main_has_backdrop && std::ranges::none_of(found.insets, &FrameInset::has_backdrop)) {
    return {};
  }
  auto picture = backdrops(session ? time : LogTime{});
  if (!picture) return picture.error();
  found.backdrop = std::move(*picture);
  found.backdrop_opacity = backdrop_opacity;
  return {};
}

Result<PreparedFrame> FrameMaker::Impl::find(const FrameRequest& request, StateDamage* damage) {
  StateDamage its;
  auto found = findDamaged(request, its);
  if (!found || its.empty()) return found;
  if (damage == nullptr) return Error{ErrorKind::damaged, its.what(), its.where()};
  damage->add(its);
  return found;
}

Result<PreparedFrame> FrameMaker::Impl::findDamaged(const FrameRequest& request,
                                                    StateDamage& damage) {
  if (Status inside = checkTime(request.time); !inside) return inside.error();
  if (!(request.scale >= kLeastScale && request.scale <= kLargestScale)) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the scale must be {} to {}", kLeastScale, kLargestScale),
                 {}};
  }
  if (Status current = context->makeCurrent(); !current) return current.error();
  PreparedFrame found;
  found.terms = request;
  if (beside) setBesideLook(found.terms.style);
  const auto rung = prepareRung(request.detail);
  if (!rung) return rung.error();
  found.rung = *rung;
  for (Status known :
       {names.check(request.hide), names.check(request.show), names.check(request.style)}) {
    if (!known) return known.error();
  }
  auto choice = ViewChoice::make(request.hide, request.show);
  if (!choice) return choice.error();
  found.choice = std::move(*choice);
  // Before querying the requested state, which is only valid until the next query.
  if (asksFit(request)) {
    Timeline* const fitted_to = fit_of->session ? &*fit_of->session : nullptr;
    if (Status ready = fit_of->fitted->prepare(fitted_to, damage); !ready) return ready.error();
  }
  Timeline* const asked = session ? &*session : nullptr;
  if (Status trails = poser.findTrails(request.style, asked, request.time, damage, found.extras);
      !trails) {
    return trails.error();
  }
  if (session && request.panel) {
    if (Status counted = findRates(request.time, damage, found); !counted) return counted.error();
  }
  const auto state = stateAt(request.time, damage);
  if (!state) return state.error();
  found.state = *state;
  if (!request.joints.empty()) {
    if (session) {
      return Error{ErrorKind::bad_argument, "joints can be set only without a session", {}};
    }
    by_hand = withHand(empty_state, LogTime{}, request.joints);
    found.state = &by_hand;
  }
  found.scene = poser.pose(request.style, *found.state, found.extras);
  if (beside) {
    Status added = beside->addGhosts(found.scene, request.time, damage);
    if (!added) return added.error();
  }
  if (Status placed = placeCameras(request, found); !placed) return placed.error();
  return found;
}

Status FrameMaker::Impl::findRates(LogTime time, StateDamage& damage, PreparedFrame& found) {
  if (!rates) {
    auto reader = LogReader::open(session->log().name());
    if (!reader) return reader.error();
    rates.emplace(std::move(*reader));
  }
  auto now = rates->at(time, damage);
  if (!now) return now.error();
  found.counted = std::move(*now);
  return {};
}

void FrameMaker::Impl::addPanel(LogTime time, const PreparedFrame& found, Picture& picture) {
  const std::string shown = session ? secondsText(time - session->origin(), 3) + " s" : "";
  drawPanel(picture, panelRows(shown, found.scene, *found.state, found.counted),
            renderer->text(found.terms.scale), found.terms.scale);
}

Result<const DetailRung*> FrameMaker::Impl::prepareRung(int detail) {
  if (detail < 0 || detail > kCoarsestRung) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the level of detail must be 0 (everything) to {}", kCoarsestRung),
                 {}};
  }
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(detail)];
  // A browser's page has neither threads nor a cache for them.
  if (rung.level.geometry_error_px > 0 && !renderer->gl().is_embedded) {
    // A reproducible picture must not depend on cached files: coarser meshes are made again.
    const DetailCache cache = profile == Profile::fast ? DetailCache::ofUser() : DetailCache();
    renderer->prepareDetail(cache, static_cast<int>(std::thread::hardware_concurrency()));
    renderer->takeReadyDetail(true);
  }
  return &rung;
}

Status FrameMaker::Impl::draw(const FrameRequest& request, const PreparedFrame& found) {
  Status ready =
      view.prepare(renderer->gl(), request.width, request.height, request.samples, *found.rung);
  if (!ready) return ready.error();
  const auto drawn = view.draw(*renderer, found.shown());
  if (!drawn) return drawn.error();
  return {};
}

Status FrameMaker::Impl::prepareNumbers(const FrameRequest& request) {
  if (number_target && number_target->width() == request.width &&
      number_target->height() == request.height) {
    return {};
  }
  auto made = FrameBuffer::create(renderer->gl(), request.width, request.height, 1);
  if (!made) return made.error();
  number_target = std::move(*made);
  return {};
}

FrameMaker::FrameMaker(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FrameMaker::~FrameMaker() = default;
FrameMaker::FrameMaker(FrameMaker&&) noexcept = default;
FrameMaker& FrameMaker::operator=(FrameMaker&&) noexcept = default;

Result<FrameMaker> FrameMaker::open(Cell cell, std::optional<Timeline> session, Profile profile) {
  auto context = makeOffscreenContext(profile);
  if (!context) return context.error();
  return open(std::move(cell), std::move(session), profile, std::move(*context));
}

Result<FrameMaker> FrameMaker::open(Cell cell, std::optional<Timeline> session, Profile profile,
                                    std::unique_ptr<RenderContext> context) {
  auto impl = std::make_unique<Impl>(std::move(cell), profile);
  impl->session = std::move(session);
  impl->context = std::move(context);
  auto renderer = Renderer::create(*impl->context, impl->cell, profile);
  if (!renderer) return renderer.error();
  impl->renderer = std::move(*renderer);
  // A page's log is no file.
  if (impl->session && impl->renderer->gl().is_embedded) {
    impl->names.expectOthers();
  } else if (impl->session) {
    impl->names.useLog(impl->session->log().name());
  }
  impl->fitted.emplace(impl->cell, *impl->renderer);
  // Everything is in memory now: a temporary folder of this cell can be removed.
  impl->cell.keeps_files.reset();
  return FrameMaker(std::move(impl));
}

void FrameMaker::showState(const SessionState* state) { impl_->given = state; }

void FrameMaker::showSession(Timeline session) {
  Impl& impl = *impl_;
  impl.session.emplace(std::move(session));
  impl.fitted.emplace(impl.cell, *impl.renderer);
  impl.poser.forgetTrails();
  impl.rates.reset();
}

void FrameMaker::showBeside(Timeline beside, EventAlignment alignment) {
  impl_->names.expectBeside();
  impl_->beside.emplace(impl_->cell, std::move(beside), std::move(alignment));
}

void FrameMaker::showBackdrop(std::string camera, double opacity, BackdropAt pictures) {
  impl_->backdrop_camera = std::move(camera);
  impl_->backdrop_opacity = opacity;
  impl_->backdrops = std::move(pictures);
}

Result<Picture> FrameMaker::frame(const FrameRequest& request, StateDamage* damage) {
  Impl& impl = *impl_;
  const auto found = impl.find(request, damage);
  if (!found) return found.error();
  if (Status drawn = impl.draw(request, *found); !drawn) return drawn.error();
  Picture picture = impl.view.picture().read();
  if (request.panel) impl.addPanel(request.time, *found, picture);
  return picture;
}

Status FrameMaker::show(const FrameRequest& request, StateDamage* damage) {
  Impl& impl = *impl_;
  FrameRequest without_panel = request;
  without_panel.panel = false;
  const auto found = impl.find(without_panel, damage);
  if (!found) return found.error();
  if (Status drawn = impl.draw(request, *found); !drawn) return drawn.error();
  impl.view.picture().blitTo(0);
  return {};
}

Result<IdentityFrame> FrameMaker::identity(const FrameRequest& request, StateDamage* damage) {
  Impl& impl = *impl_;
  FrameRequest without_panel = request;
  without_panel.panel = false;
  const auto found = impl.find(without_panel, damage);
  if (!found) return found.error();
  Status ready = impl.prepareNumbers(request);
  if (!ready) return ready.error();
  return impl.renderer->identity(found->shown(), *impl.number_target);
}

Result<DepthFrame> FrameMaker::depth(const FrameRequest& request, StateDamage* damage) {
  Impl& impl = *impl_;
  FrameRequest without_panel = request;
  without_panel.panel = false;
  const auto found = impl.find(without_panel, damage);
  if (!found) return found.error();
  Status ready = impl.prepareNumbers(request);
  if (!ready) return ready.error();
  return impl.renderer->depth(found->shown(), *impl.number_target);
}

Result<std::optional<PickedLink>> FrameMaker::pick(const FrameRequest& request, double x, double y,
                                                   StateDamage* damage) {
  const auto found = impl_->find(request, damage);
  if (!found) return found.error();
  return impl_->renderer->pick(found->shown(), request.width, request.height, x, y);
}

Result<CameraView> FrameMaker::camera(const FrameRequest& request) {
  const auto found = impl_->find(request, nullptr);
  if (!found) return found.error();
  return found->camera;
}

Result<std::vector<PicturedView>> FrameMaker::views(const FrameRequest& request) {
  const auto found = impl_->find(request, nullptr);
  if (!found) return found.error();
  std::vector<PicturedView> views;
  views.push_back({false, request.camera, {0, 0, request.width, request.height}, found->camera});
  for (std::size_t i = 0; i < found->insets.size(); ++i) {
    const FrameInset& inset = found->insets[i];
    views.push_back({true, found->inset_cameras[i], inset.part, inset.camera});
  }
  return views;
}

bool FrameMaker::asksFit(const FrameRequest& request) const { return impl_->asksFit(request); }
void FrameMaker::fitLike(FrameMaker& other) { impl_->fit_of = other.impl_.get(); }

bool FrameMaker::makeNextDetail() { return impl_->renderer->makeNextDetail(); }
void FrameMaker::finishPictures() { impl_->renderer->finishPictures(); }
bool FrameMaker::readNextPicture() { return impl_->renderer->readNextPicture(); }

const RendererKey& FrameMaker::key() const { return impl_->renderer->key(); }
const std::string& FrameMaker::inputsHash() const { return impl_->renderer->inputsHash(); }
const std::vector<std::string>& FrameMaker::warnings() const { return impl_->renderer->warnings(); }
const Cell& FrameMaker::cell() const { return impl_->cell; }
Timeline* FrameMaker::session() { return impl_->session ? &*impl_->session : nullptr; }

}  // namespace rocinante
