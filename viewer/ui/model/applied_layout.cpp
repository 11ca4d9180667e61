#include "viewer/ui/model/applied_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "core/series/derived_value.h"
#include "viewer/render/fitted_cameras.h"
#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// A value of a device that the window shows, or of none; why not otherwise.
Result<SeriesKey> plottedKey(const std::string& text, const std::string& plotted,
                             const ViewModel& model) {
  auto key = parseSeriesKey(text);
  if (!key) return Error{ErrorKind::not_found, notPlotted(plotted), {}};
  if (key->isOfDevice() && model.scene().findDevice(key->name) == nullptr) {
    return Error{ErrorKind::not_found,
                 fmt::format("no device is named `{}`, so `{}` is not plotted", key->name, plotted),
                 {}};
  }
  return *std::move(key);
}

/// Adds what a layout plots, a value or one over another. Why it is not plotted, or empty.
std::string addPlot(const std::string& text, ViewModel& model) {
  PlotBoard& board = model.viewer.plots;
  const auto path = parsePath(text);
  const auto y = plottedKey(path ? path->first : text, text, model);
  if (!y.ok()) return y.error().what;
  bool has_room = true;
  if (path) {
    const auto x = plottedKey(path->second, text, model);
    if (!x.ok()) return x.error().what;
    if (!y->isValue() || !x->isValue()) {
      return fmt::format("`{}` is not plotted: counts of packets have no x-y plot", text);
    }
    has_room = board.addPath(*y, *x);
  } else {
    has_room = board.add(*y);
  }
  return has_room ? "" : fmt::format("there is no room for the plot of `{}`", text);
}

/// What to say of a camera that the window has not; `where` ends the sentence.
std::string missingCamera(const std::string& name, const char* where) {
  const std::string_view device = FittedCameras::deviceOf(name);
  if (device.empty()) return fmt::format("there is no camera `{}`{}", name, where);
  return fmt::format("no device is named `{}`, so there is no camera `{}`{}", device, name, where);
}

}  // namespace

ViewLayout layoutOf(const ViewModel& model) {
  ViewLayout layout;
  layout.is_light = model.viewer.panels.is_light;
  const bool is_named = !model.cameraName().empty();
  if (is_named) layout.camera = model.cameraName();
  layout.panels = model.viewer.panels.places.places;
  const PlotBoard& board = model.viewer.plots;
  ViewLayout::Plots plots{{}, board.height, board.hidden};
  for (const PlotBoard::Curve& curve : board.curves()) plots.values.push_back(curve.key.text());
  for (const PlotBoard::Path& path : board.paths()) plots.values.push_back(path.text());
  layout.plots = std::move(plots);
  layout.insets.emplace();
  for (const InsetChoice& choice : model.viewer.insets) {
    if (choice.shown) layout.insets->push_back(insetText(choice.inset));
  }
  return layout;
}

std::vector<std::string> applyLayout(const ViewLayout& layout, ViewModel& model) {
  std::vector<std::string> left_out;
  if (layout.is_light) model.viewer.panels.is_light = *layout.is_light;
  const bool is_of_scene = chooseCamera(layout.camera, model.scene()).ok();
  if (!layout.camera.empty() && is_of_scene) {
    model.useCamera(layout.camera);
  } else if (hasCamera(layout.camera, model.cell(), model.scene())) {
    model.viewer.built_in_wanted = layout.camera;
  } else if (!layout.camera.empty()) {
    left_out.push_back(missingCamera(layout.camera, ""));
  }
  model.viewer.panels.places = {};
  model.viewer.panels.places.places = layout.panels;
  if (layout.plots) {
    PlotBoard& board = model.viewer.plots;
    board.clear();
    for (const std::string& value : layout.plots->values) {
      const std::string fault = addPlot(value, model);
      if (!fault.empty()) left_out.push_back(fault);
    }
    board.height = std::max(layout.plots->height, PlotBoard::kLeastHeight);
    board.hidden = layout.plots->hidden;
  }
  if (!layout.insets) return left_out;
  model.viewer.insets.clear();
  for (const std::string& text : *layout.insets) {
    const auto inset = parseInset(text);
    if (!inset.ok()) {
      left_out.push_back(inset.error().what);
    } else if (!hasCamera(inset->camera, model.cell(), model.scene())) {
      left_out.push_back(missingCamera(inset->camera, " for an inset"));
    } else {
      model.viewer.insets.push_back({*inset, true});
    }
  }
  return left_out;
}

void noteLeftOut(const std::string& name, const std::vector<std::string>& left_out,
                 ViewModel& model) {
  PanelState& panels = model.viewer.panels;
  panels.dropNotes(PictureNote::Of::layout);
  for (const std::string& each : left_out) {
    panels.notes.push_back({name + ": " + each, false, PictureNote::Of::layout});
  }
}

std::vector<SeriesKey> unstatedSignals(const ViewModel& model) {
  const StudyPicture* const picture = model.viewer.picture.get();
  std::vector<SeriesKey> unstated;
  if (picture == nullptr || picture->stated == nullptr) return unstated;
  const auto look = [&](const SeriesKey& plotted) {
    for (const SeriesKey& key : statedOf(plotted)) {
      if (key.kind == SeriesKey::Kind::signal && std::ranges::count(*picture->stated, key) == 0 &&
          std::ranges::count(unstated, key) == 0) {
        unstated.push_back(key);
      }
    }
  };
  for (const PlotBoard::Curve& curve : model.viewer.plots.curves()) look(curve.key);
  for (const PlotBoard::Path& path : model.viewer.plots.paths()) {
    look(path.y);
    look(path.x);
  }
  return unstated;
}

}  // namespace rocinante
