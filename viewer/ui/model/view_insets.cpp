#include "viewer/ui/model/view_insets.h"

#include <algorithm>
#include <cmath>

#include "viewer/render/inset_frame.h"
#include "viewer/ui/model/inset_columns.h"
#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// No smaller by the mouse: what it shows must be seen.
constexpr double kLeastDraggedPx = 48;

std::vector<std::size_t> shownInsets(const ViewModel& model) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < model.viewer.insets.size(); ++i) {
    if (model.viewer.insets[i].shown) shown.push_back(i);
  }
  return shown;
}

/// The insets of a window's picture.
struct WindowInsets {
  std::vector<std::size_t> numbers;  ///< of ViewerState::insets: those that are wanted
  InsetColumns columns;

  /// Not all of them are there as they were asked for.
  bool isChanged(const ViewModel& model) const {
    if (columns.shown.size() != numbers.size()) return true;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (columns.insets[i] != model.viewer.insets[numbers[i]].inset) return true;
    }
    return false;
  }
};

WindowInsets windowInsets(ViewModel& model, int width, int height, double scale) {
  WindowInsets result;
  const CameraView main = model.cameraView();
  std::vector<WantedInset> wanted;
  for (const std::size_t number : shownInsets(model)) {
    const InsetChoice& choice = model.viewer.insets[number];
    if (repeatsMainView(choice.inset, model.cameraName(), main, model.scene())) continue;
    result.numbers.push_back(number);
    wanted.push_back({choice.inset, choice.opened});
  }
  result.columns = fitInsets(wanted, width, height, scale);
  return result;
}

InsetCorner cornerOf(bool left, bool top) {
  if (top) return left ? InsetCorner::top_left : InsetCorner::top_right;
  return left ? InsetCorner::bottom_left : InsetCorner::bottom_right;
}

}  // namespace

std::vector<FrameInset> frameInsets(ViewModel& model, FittedCameras& fitted, int width, int height,
                                    double scale) {
  const WindowInsets window = windowInsets(model, width, height, scale);
  const std::vector<PixelRectangle> parts =
      placeInsets(window.columns.insets, width, height, scale);
  std::vector<FrameInset> shown;
  const std::string backdrop_camera = model.backdrop ? model.backdrop->camera : std::string();
  model.viewer.inset_places.clear();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].width == 0 || parts[i].height == 0) continue;
    const CellInset& inset = window.columns.insets[i];
    Result<CameraView> camera = chooseCamera(inset.camera, model.scene());
    if (!camera.ok() && FittedCameras::knows(inset.camera)) {
      camera = fitted.view(inset.camera, model.choice(), model.hiddenPaths(), model.shownPaths(),
                           parts[i].width, parts[i].height);
    }
    if (!camera.ok()) continue;
    shown.push_back(frameInset(inset, parts[i], *camera, backdrop_camera));
    model.viewer.inset_places.push_back(
        {window.numbers[window.columns.shown[i]], parts[i], *camera});
  }
  return shown;
}

void replaceInsets(ViewModel& model, int width, int height, double scale) {
  if (model.viewer.inset_places.empty()) return;
  const WindowInsets window = windowInsets(model, width, height, scale);
  const auto parts = placeInsets(window.columns.insets, width, height, scale);
  for (InsetPlace& place : model.viewer.inset_places) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (window.numbers[window.columns.shown[i]] == place.number) place.part = parts[i];
    }
  }
}

std::vector<InsetTab> insetTabs(ViewModel& model, int width, int height, double scale) {
  const WindowInsets window = windowInsets(model, width, height, scale);
  std::vector<InsetTab> tabs;
  for (const InsetColumns::Tab& tab : window.columns.tabs) {
    tabs.push_back({window.numbers[tab.number], tab.place});
  }
  return tabs;
}

void openInset(ViewModel& model, std::size_t number) {
  std::uint64_t latest = 0;
  for (const InsetChoice& choice : model.viewer.insets) latest = std::max(latest, choice.opened);
  if (number < model.viewer.insets.size()) model.viewer.insets[number].opened = latest + 1;
}

void setTerms(ViewModel& model, PictureTerms& terms) {
  terms.hide = model.hiddenPaths();
  terms.show = model.shownPaths();
  terms.style = model.frameStyle();
  std::vector<CellInset> insets;
  for (const std::size_t number : shownInsets(model))
    insets.push_back(model.viewer.insets[number].inset);
  const WindowInsets window = windowInsets(model, terms.width, terms.height, terms.scale);
  if (window.isChanged(model)) insets = window.columns.insets;
  terms.insets.reset();
  if (insets != model.cell().insets) terms.insets = std::move(insets);
}

std::optional<InsetDrag> grabInset(const ViewModel& model, double x, double y, double reach_px) {
  std::optional<InsetDrag> grabbed;
  for (const InsetPlace& place : model.viewer.inset_places) {
    const PixelRectangle& at = place.part;
    if (!(x >= at.x && y >= at.y && x < at.x + at.width && y < at.y + at.height)) continue;
    const InsetCorner corner = model.viewer.insets[place.number].inset.corner;
    const double across = isLeft(corner) ? at.x + at.width - x : x - at.x;
    const double down = isTop(corner) ? at.y + at.height - y : y - at.y;
    grabbed = InsetDrag{place.number, across < reach_px && down < reach_px, at};
  }
  return grabbed;
}

void dragInset(ViewModel& model, const InsetDrag& drag, double x, double y, int width, int height,
               double scale) {
  if (drag.number >= model.viewer.insets.size()) return;
  CellInset& inset = model.viewer.insets[drag.number].inset;
  if (!drag.sizes) {
    inset.corner = cornerOf(x < width / 2.0, y < height / 2.0);
    return;
  }
  // The corner at the picture's edge stays where it is.
  const PixelRectangle& at = drag.part;
  const double across = isLeft(inset.corner) ? x - at.x : at.x + at.width - x;
  const double down = isTop(inset.corner) ? y - at.y : at.y + at.height - y;
  const double least = kLeastDraggedPx * scale;
  const double w = std::clamp(across, least, std::max(least, 0.9 * width));
  const double h = std::clamp(down, least, std::max(least, 0.9 * height));
  // To a thousandth: such numbers are read and typed.
  const auto part = [](double of, double whole) {
    return std::clamp(std::round(of / whole * 1000) / 1000, 0.01, 1.0);
  };
  inset.width = inset.in_pixels ? std::round(w / scale) : part(w, width);
  inset.height = inset.in_pixels ? std::round(h / scale) : part(h, height);
}

Status swapInset(ViewModel& model, std::size_t number) {
  const auto place = std::ranges::find(model.viewer.inset_places, number, &InsetPlace::number);
  if (place == model.viewer.inset_places.end()) {
    return Error{ErrorKind::bad_argument, "this inset is not shown", {}};
  }
  CellInset& inset = model.viewer.insets[number].inset;
  const bool is_named = !model.cameraName().empty() && model.cameraName()[0] != '@';
  const std::string before = is_named ? model.cameraName() : viewpointText(model.cameraView());
  // `map` and `fit` are no cameras of the main view: it takes what the inset shows.
  const bool is_camera = model.scene().findCamera(inset.camera) != nullptr;
  model.useCamera(is_camera ? inset.camera : viewpointText(place->camera));
  inset.camera = before;
  inset.title.reset();  // it was of the camera before
  return {};
}

}  // namespace rocinante
