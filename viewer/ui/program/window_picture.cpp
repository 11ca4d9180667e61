#include "viewer/ui/program/window_picture.h"

#include <algorithm>

#include "viewer/ui/program/fit_corners.h"

namespace rocinante {

SceneFrame WindowPicture::frame(const RenderStyle& style) const {
  SceneFrame frame;
  frame.scene = &model_.scene();
  frame.camera = model_.cameraView();
  frame.choice = &model_.choice();
  frame.style = &style;
  frame.extras = &model_.extras();
  frame.insets = insets_;
  frame.raised_px = terms_.covered.bottom;
  frame.scale = terms_.scale;
  if (model_.backdrop && model_.backdrop->shown) {
    frame.backdrop = model_.backdrop->picture.get();
    frame.backdrop_opacity = model_.backdrop->opacity;
    frame.main_has_backdrop = model_.cameraName() == model_.backdrop->camera;
  }
  return frame;
}

Result<std::optional<DrawCounts>> WindowPicture::draw(const PictureTerms& terms, SteadyTime now) {
  terms_ = terms;
  RenderStyle style = model_.frameStyle();
  const bool drops = terms.drops_looks && model_.hasLooksByDefault();
  if (drops) style.shadows = style.contact = false;
  insets_ = frameInsets(model_, fitted_, terms.width, terms.height, terms.scale, terms.covered);
  const bool shows_fitted = std::ranges::any_of(model_.insets, [](const InsetChoice& choice) {
    return choice.shown && FittedCameras::knows(choice.inset.camera);
  });
  if (shows_fitted && !fit_damage_.empty()) {
    model_.panels.doubts.push_back("a fitted camera may miss movement: " + fit_damage_.text());
    fit_damage_ = {};
  }
  ShownScene shown;
  shown.version = version_;
  shown.camera = model_.cameraView();
  shown.style = style;
  shown.insets = insets_;
  shown.hide = model_.hiddenPaths();
  shown.show = model_.shownPaths();
  shown.raised_px = terms.covered.bottom;
  shown.scale = terms.scale;
  shown.width = terms.width;
  shown.height = terms.height;
  shown.samples = samples_;
  shown.rung = terms.rung;
  shown.drops_looks = drops;
  const SceneFrame drawn = frame(style);
  shown.backdrop = drawn.backdrop != nullptr ? drawn.backdrop->number : 0;
  shown.backdrop_opacity = drawn.backdrop_opacity;
  shown.main_has_backdrop = drawn.main_has_backdrop;
  shown.begins_plain = terms.begins_plain;
  return view_.draw(renderer_, drawn, shown, now);
}

Result<bool> WindowPicture::refine(SteadyTime now) {
  const RenderStyle style = model_.frameStyle();
  return view_.refine(renderer_, frame(style), now);
}

Result<std::optional<PickedLink>> WindowPicture::pick(const PictureClick& at) {
  // On the clicked frame, with its insets, looks and choices.
  const RenderStyle style = model_.frameStyle();
  return renderer_.pick(frame(style), terms_.width, terms_.height, at.x, at.y);
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
  if (model_.picking.active()) {
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

std::vector<Vec3> WindowPicture::corners(bool of_selection) const {
  return of_selection ? selectedCorners(model_, renderer_, fitted_)
                      : cornersToFit(model_, renderer_, fitted_);
}

}  // namespace rocinante
