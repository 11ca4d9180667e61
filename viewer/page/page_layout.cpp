#include "viewer/page/page_layout.h"

#include <set>
#include <utility>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/report/json_text.h"
#include "core/series/positional_names.h"
#include "core/series/series_scan.h"
#include "viewer/shown/plot_scale.h"
#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// The name of a value, and the series that it shows.
struct WantedCurve {
  std::string name;
  SeriesKey series;
};

/// Those that a page can draw, if the log states them.
std::vector<WantedCurve> wantedCurves(const ViewLayout& layout, const PosedScene& scene,
                                      Account& left_out) {
  std::vector<WantedCurve> wanted;
  for (const std::string& name : layout.plots->values) {
    const auto key = parseSeriesKey(name);
    const char* reason = nullptr;
    if (parsePath(name)) {
      reason = "a page draws no value over another";
    } else if (!key) {
      reason = "no value is named so";
    } else if (!key->isValue()) {
      reason = "a page draws no counts of packets";
    } else {
      wanted.push_back({name, plotValue(*key, scene).series});
    }
    if (reason != nullptr) left_out.leaveOut({.kind = "plot", .name = name, .reason = reason});
  }
  return wanted;
}

/// The names of those of which the log states numbers.
Result<Json> statedCurves(const std::vector<WantedCurve>& wanted, const Cell& cell, LogReader log,
                          Account& left_out) {
  Json names = Json::array();
  if (wanted.empty()) return names;
  SeriesScan::Options options;
  options.from = log.summary().start;
  options.until = log.summary().end;
  options.names = positionalNames(cell);
  options.cell = &cell;
  options.only.emplace();
  for (const WantedCurve& curve : wanted) options.only->insert(curve.series);
  SeriesScan scan(std::move(options));
  while (true) {
    const auto message = log.next();
    if (!message) return message.error();
    if (!*message) break;
    scan.add(**message);
  }
  for (const WantedCurve& curve : wanted) {
    if (scan.values(curve.series) != nullptr) {
      names.push_back(curve.name);
      continue;
    }
    left_out.leaveOut({.kind = "plot",
                       .name = curve.name,
                       .reason = scan.isText(curve.series)
                                     ? "it is a text, of which a page draws no curve"
                                     : "no packet of the log states it"});
  }
  return names;
}

/// Of a camera that the page has not.
const char* missingCamera(const std::string& name) {
  return name.starts_with("fit:") ? "the cell has no such device" : "the cell has no such camera";
}

Json knownInsets(const std::vector<std::string>& texts, const Cell& cell, const PosedScene& scene,
                 Account& left_out) {
  Json known = Json::array();
  for (const std::string& text : texts) {
    const auto inset = parseInset(text);
    if (inset.ok() && hasCamera(inset->camera, cell, scene)) {
      known.push_back(text);
    } else {
      left_out.leaveOut({.kind = "inset",
                         .name = text,
                         .reason = inset.ok() ? missingCamera(inset->camera) : "it is no inset"});
    }
  }
  return known;
}

}  // namespace

Result<PageLayout> pageLayout(const ViewLayout& layout, const Cell& cell, LogReader log) {
  PageLayout made;
  Json json = Json::object();
  const SessionState empty_state;
  const PosedScene scene = poseScene(cell, empty_state);
  if (!layout.camera.empty() && hasCamera(layout.camera, cell, scene)) {
    json["camera"] = layout.camera;
  } else if (!layout.camera.empty()) {
    made.left_out.leaveOut(
        {.kind = "camera", .name = layout.camera, .reason = missingCamera(layout.camera)});
  }
  if (layout.insets) json["insets"] = knownInsets(*layout.insets, cell, scene, made.left_out);
  if (layout.plots) {
    const auto wanted = wantedCurves(layout, scene, made.left_out);
    auto plots = statedCurves(wanted, cell, std::move(log), made.left_out);
    if (!plots) return plots.error();
    json["plots"] = *std::move(plots);
    json["plots_height"] = layout.plots->height;
    json["plots_hidden"] = layout.plots->hidden;
  }
  for (const auto& [name, place] : layout.panels) {
    made.left_out.leaveOut(
        {.kind = "panel", .name = name, .reason = "a page has places of its own"});
  }
  made.json = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return made;
}

}  // namespace rocinante
