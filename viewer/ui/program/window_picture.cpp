#include "viewer/ui/program/window_picture.h"

#include <algorithm>
#include <chrono>

#include "viewer/ui/program/fit_corners.h"

namespace rocinante {

SceneFrame WindowPicture::frame(const RenderStyle& style) const {
  SceneFrame frame{&model_.scene(), model_.cameraView(), &model_.choice(), &style,
                   &model_.extras()};
  frame.insets = insets_;
  frame.scale = terms_.scale;
  if (model_.backdrop && model_.backdrop->shown) {
    frame.backdrop = model_.backdrop->picture.get();
    frame.backdrop_opacity = model_.backdrop->opacity;
    frame.main_has_backdrop = hasBackdrop(model_.cameraName(), model_.backdrop->camera);
  }
  return frame;
}

RenderStyle WindowPicture::style() const {
  RenderStyle style = model_.frameStyle();
  if (model_.beside() != nullptr && model_.beside_shown) setBesideLook(style);
  return style;
}

Result<std::optional<DrawCounts>> WindowPicture::draw(WindowTerms terms, SteadyTime now) {
  setTerms(model_, terms);
  terms.samples = samples_;
  terms.style = style();
  terms.drops_looks = terms.drops_looks && model_.hasLooksByDefault();
  if (terms.drops_looks) terms.style.shadows = terms.style.contact = false;
  terms_ = terms;
  insets_ = frameInsets(model_, fitted_, terms.width, terms.height, terms.scale);
  const bool shows_fitted =
      std::ranges::any_of(model_.viewer.insets, [](const InsetChoice& choice) {
        return choice.shown && FittedCameras::knows(choice.inset.camera);
      });
  if (shows_fitted && !fit_damage_.empty()) {
    model_.viewer.panels.doubts.push_back("a fitted camera may miss movement: " +
                                          fit_damage_.text());
    fit_damage_ = {};
  }
  ShownScene shown;
  shown.version = version_;
  shown.camera = model_.cameraView();
  shown.insets = insets_;
  shown.terms = std::move(terms);
  const SceneFrame drawn = frame(terms_.style);
  shown.backdrop = drawn.backdrop != nullptr ? drawn.backdrop->number : 0;
  shown.backdrop_opacity = drawn.backdrop_opacity;
  shown.main_has_backdrop = drawn.main_has_backdrop;
  return view_.draw(renderer_, drawn, shown, now);
}

Result<bool> WindowPicture::refine(SteadyTime now) {
  const RenderStyle its = style();
  return view_.refine(renderer_, frame(its), now);
}

Result<std::optional<PickedLink>> WindowPicture::pick(const PictureClick& at) {
  // On the clicked frame, with its insets, looks and choices.
  const RenderStyle its = style();
  return renderer_.pick(frame(its), terms_.width, terms_.height, at.x, at.y);
}

Status WindowPicture::point(const PictureClick& at) {
  const auto met = pick(at);
  if (!met) return met.error();
  model_.publishing.point(*met ? std::optional((*met)->point) : std::nullopt);
  return {};
}

Status WindowPicture::click(const PictureClick& click) {
  const auto met = pick(click);
  if (!met) return met.error();
  if (model_.viewer.picking.active()) {
    if (*met) model_.pickPoint({(*met)->name.device, (*met)->name.link}, (*met)->point);
    return {};
  }
  if (model_.publishing.takesClicks()) {
    if (!*met) return {};
    const Selection link{(*met)->name.device, (*met)->name.link};
    model_.publishing.clicked(model_.scene(), link, (*met)->point);
    return {};
  }
  if (!*met) {
    if (!click.twice) model_.selected = {};
    return {};
  }
  const IdentityName& name = (*met)->name;
  const PosedDevice* device = model_.scene().findDevice(name.device);
  // For a device with a single link, select the device.
  const bool jointed =
      device != nullptr && device->model != nullptr && device->model->links.size() > 1;
  model_.selected = {name.device, jointed ? name.link : std::string()};
  if (click.twice) model_.holdCamera().aimAt((*met)->point);
  return {};
}

Result<double> WindowPicture::tryFrame(int rung, bool drops_looks) {
  RenderStyle its = style();
  if (drops_looks && model_.hasLooksByDefault()) its.shadows = its.contact = false;
  return drawAside(its, rung);
}

Result<double> WindowPicture::drawAside(const RenderStyle& style, int rung) {
  const SteadyTime began = std::chrono::steady_clock::now();
  ScaledView view;
  const DetailRung& drawn = kDetailRungs[static_cast<std::size_t>(rung)];
  if (auto ready = view.prepare(renderer_.gl(), terms_.width, terms_.height, terms_.samples, drawn);
      !ready) {
    return ready.error();
  }
  if (auto done = view.draw(renderer_, frame(style)); !done.ok()) return done.error();
  renderer_.gl().Finish();
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
  return took.count();
}

Status WindowPicture::tryClick(int rung) {
  const auto met = pick({terms_.width / 2.0, terms_.height / 2.0, false});
  if (!met.ok()) return met.error();
  RenderStyle its = style();
  its.shadows = its.contact = false;
  // What is outlined by the first click is not known; that something is, has to be compiled.
  const auto& devices = model_.scene().devices;
  if (its.outlined.empty() && !devices.empty()) its.outlined.push_back(devices.front().name);
  const auto drawn = drawAside(its, rung);
  return drawn.ok() ? Status() : drawn.error();
}

std::vector<Vec3> WindowPicture::corners(bool of_selection) const {
  return of_selection ? selectedCorners(model_, renderer_, fitted_)
                      : cornersToFit(model_, renderer_, fitted_);
}

}  // namespace rocinante
